#pragma once

namespace specula {

/// Of the program and of what it writes into its files; set by the build.
inline constexpr const char* program_version = SPECULA_VERSION;

}  // namespace specula
