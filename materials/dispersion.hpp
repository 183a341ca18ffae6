#pragma once

#include <variant>

#include "materials/models/cole_cole.hpp"
#include "materials/models/conductive.hpp"
#include "materials/models/constant.hpp"
#include "materials/models/debye.hpp"
#include "materials/models/double_debye.hpp"
#include "materials/models/mixture.hpp"
#include "materials/models/power_law.hpp"
#include "materials/models/tabulated.hpp"
#include "materials/models/water.hpp"
#include "materials/models/wood.hpp"

namespace specula {

/// How the permittivity depends on frequency. To add a model: write models/<name>.hpp with `kind`,
/// `at(frequency_hz)` and `read(section)`, and add the type here. A model with a grain has
/// `grained(frequency_hz)` too; one made of other materials has `read(section, lookup)` and
/// `ingredients()`.
using Dispersion = std::variant<Constant, PowerLaw, Conductive, Debye, DoubleDebye, ColeCole, Water,
                                Tabulated, Mixture, Wood>;

}  // namespace specula
