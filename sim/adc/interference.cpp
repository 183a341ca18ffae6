#include "sim/adc/interference.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// What the decimation filter passes of a beat at a share of the sample rate: all up to 0.4,
/// nothing from 0.5 on.
double passed(double share) {
    const double above = (std::abs(share) - 0.4) / 0.1;
    if (above <= 0.0) return 1.0;
    return above >= 1.0 ? 0.0 : 0.5 * (1.0 + std::cos(pi * above));
}

}  // namespace

Interference::Interference(const Radar& radar, const Interferer& other)
    : ours_(radar.chirp), other_(other) {}

void Interference::add(std::span<std::complex<double>> beat, const Meeting& meeting,
                       Stream& stream) const {
    const double phase_turns = stream.uniform();
    for (std::size_t i = 0; i < beat.size(); ++i) {
        const double t = static_cast<double>(i) / ours_.sample_rate_hz;
        const double since_s = std::fmod(t + meeting.lead_s, other_.period_s);
        if (since_s > other_.ramp_s) continue;
        const double begun_s = t - since_s;  // of the other's present ramp
        const double at_begin_hz = ours_.start_hz + ours_.slope_hz_s * begun_s - other_.start_hz;
        const double slope_hz_s = ours_.slope_hz_s - other_.slope_hz_s;
        const double beat_hz = at_begin_hz + slope_hz_s * since_s;
        const double weight = passed(beat_hz / ours_.sample_rate_hz);
        if (weight == 0.0) continue;
        const double turns =
            phase_turns + at_begin_hz * since_s + 0.5 * slope_hz_s * since_s * since_s;
        beat[i] +=
            meeting.amplitude * weight * std::polar(1.0, two_pi * (turns - std::floor(turns)));
    }
}

}  // namespace specula
