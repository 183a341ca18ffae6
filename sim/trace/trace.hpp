#pragma once

#include <optional>

#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/scatter.hpp"
#include "sim/trace/target.hpp"

namespace specula {

class ThinPlate;

/// How far to go.
struct TraceSettings {
    double highest_hz = 0.0;     ///< the sums are good up to here ...
    double accuracy_db = 0.1;    ///< of the sums against the converged integrals, 1e-6 to 3
    int max_bounces = 3;         ///< surfaces a wave may meet, 1 to 4
    bool edge_currents = false;  ///< add what free edges radiate beyond physical optics
    double lowest_hz = 0.0;      ///< ... and down to here; a narrow band needs fewer points
    double layer_path_m = 0.0;   ///< way in the layers of bodies, for that; see Detail
};

/// What a radar sees of a target, ready to be summed at any frequency up to `highest_hz`.
///
/// Every surface is covered by Gauss-Legendre points on its true shape, as many as the phase and
/// the accuracy need; where antennas see only part of a patch, it is cut smaller. Waves reach a
/// surface straight, over flat faces (images of the TX, exact for spherical waves), and through
/// sheets.
/// @eq PHYSICS.md#surface-integral, #quadrature, #images, #edge-currents
/// Limit: curved faces pass no wave on to other faces; sheets let waves pass straight on.
Scatter trace(const Target& target, const AntennaSet& antennas, const TraceSettings& settings);
/// @in  plate  ThinPlate::of the same, whose nodes others may need too
Scatter trace(const Target& target, const AntennaSet& antennas, const TraceSettings& settings,
              std::optional<ThinPlate>& plate);

}  // namespace specula
