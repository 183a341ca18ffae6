#pragma once

#include "sim/core/random.hpp"

namespace specula {

/// A share of Beta(shape, shape), in (0, 1).
/// @in  shape  0.05 to 1
/// @eq  M. D. Johnk 1964, Metrika 8: u^(1/a) / (u^(1/a) + v^(1/a)) where that sum is at most 1
double mixing_share(double shape, Stream& stream);

}  // namespace specula
