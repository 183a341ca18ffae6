#pragma once

#include <optional>

#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/scatter.hpp"
#include "sim/trace/target.hpp"
#include "sim/trace/trace_settings.hpp"

namespace specula {

class ThinPlate;

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
