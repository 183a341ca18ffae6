#pragma once

#include <filesystem>

namespace specula {

/// The folder that holds materials/ and scenes/: $SPECULA_HOME, else what `cmake --install` put
/// beside the program, else the source tree it was built from.
std::filesystem::path home_folder();

}  // namespace specula
