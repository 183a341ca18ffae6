#pragma once

#include "sim/channel/channel.hpp"

namespace specula {

/// Mean of |h|^2 over all pieces with the same statistics, of the diffuse echo alone: cells are
/// independent, so their powers add.
/// @in   cells  a route of diffuse_cells, no speckle drawn
/// @out  (rx, frequency)
/// @eq   PHYSICS.md#speckle
std::vector<double> mean_diffuse_power(const RouteScatter& cells,
                                       std::span<const Reflector> reflectors,
                                       const FrequencyComb& comb);

}  // namespace specula
