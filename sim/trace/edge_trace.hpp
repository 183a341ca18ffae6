#pragma once

#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/scatter.hpp"
#include "sim/trace/target.hpp"
#include "sim/trace/trace_settings.hpp"

namespace specula {

/// What the free edges of every body radiate, where TX and RX see the edge from the same side and
/// nothing stands between: straight ways only, neither over mirrors nor through sheets.
/// @eq PHYSICS.md#edge-currents
std::vector<EdgeScatter> trace_edges(const Target& target, const AntennaSet& antennas,
                                     const TraceSettings& settings);

}  // namespace specula
