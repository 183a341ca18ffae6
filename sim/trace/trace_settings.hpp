#pragma once

namespace specula {

/// How far to go.
struct TraceSettings {
    double highest_hz = 0.0;     ///< the sums are good up to here ...
    double accuracy_db = 0.1;    ///< of the sums against the converged integrals, 1e-6 to 3
    int max_bounces = 3;         ///< surfaces a wave may meet, 1 to 4
    bool edge_currents = false;  ///< add what free edges radiate beyond physical optics
    double lowest_hz = 0.0;      ///< ... and down to here; a narrow band needs fewer points
    double layer_path_m = 0.0;   ///< way in the layers of bodies, for that; see Detail
};

}  // namespace specula
