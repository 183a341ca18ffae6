#pragma once

#include "sim/trace/trace.hpp"

namespace specula {

/// A rectangle of a plate's face, in the plate's own x and y.
struct Patch {
    double x_m[2];
    double y_m[2];

    double x_at(double u) const { return 0.5 * ((x_m[1] - x_m[0]) * u + x_m[0] + x_m[1]); }
    double y_at(double v) const { return 0.5 * ((y_m[1] - y_m[0]) * v + y_m[0] + y_m[1]); }
};

/// Phase centres in the scene's frame.
struct AntennaPair {
    Vector3 tx_m;
    Vector3 rx_m;
};

/// Points along x and y that a patch needs.
struct PointCount {
    int x;
    int y;
};

/// How many Gauss-Legendre points integrate exp(-jk path) over a patch.
///
/// n points on [-1, 1] lie n / (pi sqrt(1 - u^2)) dense; each turn of the phase needs two of them,
/// and a few more make the error fall below 1e-6. May exceed largest_gauss_rule: then cut the
/// patch.
/// @eq PHYSICS.md#quadrature
PointCount points_needed(const PlateView& view, const AntennaPair& pair, const Patch& patch,
                         double wavelength_m);

}  // namespace specula
