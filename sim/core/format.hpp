#pragma once

#include <fmt/format.h>

namespace specula {

/// The one door to text formatting. GCC 12 has no <format>; when every supported compiler does,
/// this file is the only one that changes.
using fmt::format;

}  // namespace specula
