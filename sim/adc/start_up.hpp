#pragma once

#include <vector>

namespace specula {

/// The decimation filter in front of the ADC's output: linear phase, `latency_samples` of its
/// output to either side of its middle.
struct DecimationFilter {
    int latency_samples = 11;
    double fraction = 0.0;  ///< where its first input lies between output samples
};

/// What the filter puts out when its first input is a pulse: a band-limited impulse, tapered by a
/// half cosine, 1 at the sample nearest to the pulse.
/// @out  (sample - latency_samples .. sample + latency_samples)
/// @eq   PHYSICS.md#start-up
std::vector<double> start_up_ringing(const DecimationFilter& filter);

}  // namespace specula
