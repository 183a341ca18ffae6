#pragma once

#include <vector>

#include "sim/trace/quadrature.hpp"

namespace specula {

/// A point of the quadrature: where, how much area, and its front side.
struct WeightedPoint {
    Vector3 point_m;
    Vector3 normal;  ///< unit
    double area_m2;
};

/// Appends the Gauss-Legendre points of a patch, along u first.
/// @in  count  each at most largest_gauss_rule
void append_points_on(const Surface& surface, const Patch& patch, PointCount count,
                      std::vector<WeightedPoint>& points);

std::vector<WeightedPoint> points_on(const Surface& surface, const Patch& patch, PointCount count);

/// A patch whose ways differ is halved until it is this small, in shares of a wavelength.
inline constexpr double smallest_cut_wavelengths = 0.1;
/// Where other faces may cast shadows, ways are compared at no fewer points per axis of a patch
/// than this, however few the integral needs.
inline constexpr int fewest_ways = 5;

}  // namespace specula
