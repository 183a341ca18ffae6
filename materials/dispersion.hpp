#pragma once

#include <variant>

#include "materials/models/conductive.hpp"
#include "materials/models/constant.hpp"
#include "materials/models/power_law.hpp"

namespace specula {

/// How the permittivity depends on frequency. To add a model: write models/<name>.hpp with `kind`,
/// `at(frequency_hz)` and `read(section)`, and add the type here.
using Dispersion = std::variant<Constant, PowerLaw, Conductive>;

}  // namespace specula
