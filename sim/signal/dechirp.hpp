#pragma once

#include <vector>

#include "scenes/chirp.hpp"
#include "sim/channel/channel.hpp"

namespace specula {

/// The transmit frequency at each sample of a chirp, from the start of the ramp on.
FrequencyComb comb_of(const Chirp& chirp);

/// The beat between what is sent and what comes back, per unit of transmitted amplitude, as an
/// analytic signal: the mixer delivers its real part.
///
/// Holds the samples from the start of the ramp, since filters settle on those before the first
/// one kept.
struct BeatSignal {
    int n_rx = 0;
    int n_samples = 0;              ///< settling ones included
    std::vector<Complex> analytic;  ///< (rx, sample)

    const Complex* of_rx(int rx) const {
        return &analytic[static_cast<std::size_t>(rx) * static_cast<std::size_t>(n_samples)];
    }
};

/// The beat sample at t_n is the conjugate channel at the frequency sent at t_n, turned by the
/// residual phase -pi S tau^2 of the channel's reference path.
/// @eq PHYSICS.md#dechirp
/// Limit: the residual phase is that of the middle path; over a 30 cm plate at 45 cm it differs by
/// less than 1 mrad.
BeatSignal dechirp(const Channel& channel, const Chirp& chirp);

}  // namespace specula
