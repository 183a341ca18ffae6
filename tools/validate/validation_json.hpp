#pragma once

#include <string>

#include "tools/validate/verdict.hpp"

namespace specula {

/// Everything that was computed, for other programs: UTF-8 JSON, one object per case, point and
/// quantity. Complex numbers are [re, im]; what is not finite is null.
std::string validation_json(const Validation& validation);

}  // namespace specula
