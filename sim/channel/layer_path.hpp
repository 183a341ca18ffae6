#pragma once

#include "materials/stack.hpp"

namespace specula {

/// How much way within its layers a stack's coefficients go through before less than a
/// ten-thousandth is left, weighted by how fast it changes with the cosine of incidence:
/// 2 d / |q| per turn in a layer, q its longitudinal wave number at normal incidence.
///
/// Says how finely angles have to be looked at (Detail::layer_path_m).
/// @out  m; 0 for metals and bare half-spaces
/// @eq   PHYSICS.md#thinned-quadrature
double layer_path_m(const Stack& stack);

}  // namespace specula
