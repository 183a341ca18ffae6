#include "sim/adc/ramp_noise.hpp"

#include <cmath>

namespace specula {

RampNoise::RampNoise(const Radar& radar) {
    const double level = radar.receiver.phase_noise_dbc_hz;
    if (!std::isfinite(level)) return;
    // S_phi = 2 L (1 MHz / f)^2 in rad^2/Hz; frequency error f^2 S_phi, over half the sample rate.
    const double spectrum_hz2_hz = 2.0 * std::pow(10.0, 0.1 * level) * 1e12;
    const double rate_hz = radar.chirp.sample_rate_hz;
    const double sd_hz = std::sqrt(spectrum_hz2_hz * 0.5 * rate_hz);
    sd_steps_ = sd_hz * rate_hz / radar.chirp.slope_hz_s;
}

std::vector<double> RampNoise::draw(std::size_t n_samples, Stream& stream) const {
    std::vector<double> errors(n_samples);
    stream.fill_normal(errors);
    for (double& error : errors) error *= sd_steps_;
    return errors;
}

void RampNoise::apply(std::span<std::complex<double>> beat, std::span<const double> error_steps) {
    const auto n = static_cast<std::ptrdiff_t>(beat.size());
    const std::vector<std::complex<double>> nominal(beat.begin(), beat.end());
    const auto at = [&](std::ptrdiff_t i) {  // continued in a straight line beyond the ends
        if (i < 0) return nominal[0] + static_cast<double>(i) * (nominal[1] - nominal[0]);
        if (i < n) return nominal[static_cast<std::size_t>(i)];
        const auto& last = nominal[static_cast<std::size_t>(n - 1)];
        return last +
               static_cast<double>(i - n + 1) * (last - nominal[static_cast<std::size_t>(n - 2)]);
    };
    for (std::ptrdiff_t i = 0; i < n; ++i) {
        const auto slope = (8.0 * (at(i + 1) - at(i - 1)) - (at(i + 2) - at(i - 2))) / 12.0;
        beat[static_cast<std::size_t>(i)] += error_steps[static_cast<std::size_t>(i)] * slope;
    }
}

}  // namespace specula
