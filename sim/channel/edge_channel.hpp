#pragma once

#include "sim/channel/channel.hpp"

namespace specula {

/// What a body's edges radiate over what those of a perfect conductor would: minus its reflection
/// at normal incidence where it reflects nearly like one, that is, metals with or without a thin
/// coat; 0 for all others, of whose edges no closed form is known that does good.
/// @eq PHYSICS.md#edge-currents
Complex edge_coefficient(const Stack& stack);

/// What the free edges of all bodies add at one frequency for one RX.
Complex edge_sum(const Scatter& scatter, int rx, std::span<const Reflector> reflectors,
                 double frequency_hz);

void add_edges(const Scatter& scatter, std::span<const Reflector> reflectors,
               const FrequencyComb& comb, Channel& channel);

}  // namespace specula
