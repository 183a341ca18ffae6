#pragma once

#include <string>

#include "sim/dataset/dataset.hpp"

namespace specula {

/// FNV-1a, 64 bits, over the codes, features and labels, as 16 hexadecimal digits: equal for equal
/// recordings, whatever file they came from. Not proof against malice.
std::string fingerprint(const Dataset& dataset);

}  // namespace specula
