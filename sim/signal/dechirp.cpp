#include "sim/signal/dechirp.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

FrequencyComb comb_of(const Chirp& chirp) {
    return {.first_hz = chirp.frequency_hz(-chirp.settle_samples()),
            .step_hz = chirp.slope_hz_s / chirp.sample_rate_hz,
            .n = chirp.settle_samples() + chirp.n_samples};
}

BeatSignal dechirp(const Channel& channel, const Chirp& chirp) {
    SPECULA_EXPECT(channel.n_frequencies == comb_of(chirp).n);
    const double delay_s = channel.reference_path_m / speed_of_light_m_s;
    const Complex residual = std::polar(1.0, -pi * chirp.slope_hz_s * delay_s * delay_s);
    BeatSignal beat{.n_rx = channel.n_rx, .n_samples = channel.n_frequencies, .analytic = channel.h};
    for (Complex& sample : beat.analytic) sample = std::conj(sample) * residual;
    return beat;
}

}  // namespace specula
