#pragma once

#include <span>

#include "sim/trace/surface.hpp"

namespace specula {

/// Where the phase of a patch's integrand comes from: exp(-jk (|source - p| + |p - rx|)).
struct PhaseCentres {
    Vector3 source_m;  ///< the TX, or its image in the faces on the way
    Vector3 rx_m;
};

/// Points along u and v of a patch; either may exceed largest_gauss_rule: then the patch is cut.
struct PointCount {
    int u;
    int v;
};

/// How many Gauss-Legendre points integrate exp(-jk path) over a patch.
///
/// For the phase a u + q u^2 on [-1, 1] the error of n points falls like the Bessel functions
/// J_2n(a) and J_n(q/2), that is, steeply beyond 2n = a and 2n = q; `a` is the largest rate of the
/// phase, weighted by the spacing of the points sqrt(1 - u^2), and q follows from how the rate
/// changes over the patch.
/// @in  accuracy_db  > 0: error of the sum relative to what the patch would give in phase; kept
///                   with room down to 1e-3, within a factor of three at 1e-6
/// @eq  PHYSICS.md#quadrature
PointCount points_needed(const Surface& surface, const Patch& patch, const PhaseCentres& centres,
                         double wavelength_m, double accuracy_db);

/// What else than the path turns the integrand, and over which band.
struct Detail {
    double centre_rad_m = 0.0;     ///< wave number whose phase is summed exactly
    double half_band_rad_m = 0.0;  ///< how far the others are from it
    /// Way within layers: their coefficients turn by up to the highest wave number times this
    /// times the change of the cosine of incidence.
    double layer_path_m = 0.0;
};

/// Points for a sum of phases, and those that carry the rest of the integrand.
struct ThinCounts {
    PointCount dense;
    PointCount thin;
};

/// `dense` is what points_needed gives at the highest wave number. `thin` is how many Chebyshev
/// points per axis carry all of the integrand but the phase at one wave number: the antennas'
/// patterns, the spread, the coefficients, and what the phase at other frequencies of the band
/// differs. Both as the most demanding of some RX needs them.
/// @eq  PHYSICS.md#thinned-quadrature
ThinCounts thin_points_needed(const Surface& surface, const Patch& patch, const Vector3& source_m,
                              std::span<const Vector3> rx_m, const Detail& detail,
                              double accuracy_db);

}  // namespace specula
