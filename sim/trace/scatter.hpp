#pragma once

#include <vector>

namespace specula {

/// The surface integral of one (tx, rx) pair as a sum over points, geometry only.
///
/// h(f) = -j/(8 pi) Sum_i exp(-jk path_i) [ incident_i + r_TE(f, cos_i) te_i + r_TM(f, cos_i) tm_i
/// ] with the reflection coefficients of whatever the surface is made of.
/// @eq PHYSICS.md#surface-integral
struct PairScatter {
    std::vector<double> path_m;         ///< (point) TX to point to RX
    std::vector<double> cos_incidence;  ///< (point) at the TX side
    std::vector<double> incident;       ///< (point) weights, dimensionless
    std::vector<double> te;             ///< (point)
    std::vector<double> tm;             ///< (point)
};

/// What the radar sees of a surface: no material in it, so that one trace serves any of them.
struct Scatter {
    std::vector<PairScatter> rx;  ///< (rx); empty lists where nothing is seen

    struct Extent {
        double low = 0.0;
        double high = 0.0;
    };
    Extent path_m() const;         ///< over all pairs; {0, 0} when nothing is seen
    Extent cos_incidence() const;  ///< over all pairs; {1, 1} when nothing is seen
};

}  // namespace specula
