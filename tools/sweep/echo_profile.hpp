#pragma once

#include <vector>

#include "scenes/radar.hpp"
#include "sim/channel/channel.hpp"

namespace specula {

/// The range profile of an echo alone: no noise, leakage or high-pass.
struct EchoProfile {
    std::vector<double> bin_lsb;  ///< (bin) a tone reads its amplitude in ADC codes
    int peak_bin = 0;
    double centroid_bin = 0.0;  ///< of the power in all bins; 0 where there is none
};

/// Windows the beat of a chirp (Blackman where the chip's library has one of that length),
/// transforms it, and takes the mean magnitude over the RX, as the descriptor of the classifier
/// does.
/// @in   channel  over `comb_of(radar.chirp)`
/// @eq   PHYSICS.md#dechirp, #range-profile
EchoProfile echo_profile(const Channel& channel, const Radar& radar);

}  // namespace specula
