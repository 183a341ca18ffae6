#pragma once

#include "sim/recording/axis_order.hpp"

namespace specula {

/// How much more the codes jump from sample to sample in the order they were read in than in the
/// other one that is common: receivers interleaved sample by sample instead of one after another,
/// or the reverse. About 1 or below where the order is right, or where there is only noise.
///
/// Beat signals are sampled well above their frequency, and receivers differ in offset and phase;
/// read in the wrong order, a row hops from one receiver to the next.
/// @in   cube  as arranged; one receiver has one order, and gives 0
/// @out  ratio of the summed squared differences, >= 0
/// Limit: a single strong tone at a third of the sample rate looks alike with three receivers.
double interleaving_suspicion(const CodeCube& cube);

}  // namespace specula
