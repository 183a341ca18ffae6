#include "scenes/chirp.hpp"

#include <bit>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

double Chirp::frequency_hz(int n) const {
    return start_hz + slope_hz_s * (settle_samples() + n) / sample_rate_hz;
}

double Chirp::centre_hz() const {
    return start_hz + slope_hz_s * (settle_samples() + 0.5 * n_samples) / sample_rate_hz;
}

double Chirp::bandwidth_hz() const {
    return slope_hz_s * n_samples / sample_rate_hz;
}

/// @eq PHYSICS.md#bin-shift
double Chirp::bin_m() const {
    return speed_of_light_m_s / (2.0 * bandwidth_hz());
}

double Chirp::beat_hz(double range_m) const {
    return slope_hz_s * 2.0 * range_m / speed_of_light_m_s;
}

double Chirp::max_range_m() const {
    return pass_band * sample_rate_hz / slope_hz_s * speed_of_light_m_s / 2.0;
}

Chirp Chirp::read(Section& section) {
    Chirp chirp{
        .start_hz = section.quantity("start", Unit::frequency, Range::between(1e9, 300e9)),
        .slope_hz_s = section.quantity("slope", Unit::slope, Range::between(1e9, 1e15)),
        .sample_rate_hz =
            section.quantity("sample_rate", Unit::frequency, Range::between(1e4, 1e8)),
        .n_samples = section.count("n_samples", Range::between(16, 1024)),
        .skip_samples = section.count("skip_samples", Range::between(0, 1024), 0),
        .filter_latency_samples = section.count("filter_latency_samples", Range::between(0, 64), 0),
        .ramp_end_s = section.quantity("ramp_end", Unit::time, Range::above(0.0)),
        .idle_s = section.quantity("idle", Unit::time, Range::between(0.0, 1.0), 0.0),
        .pass_band = section.number("pass_band", Range::inside(0.0, 0.5), 0.45),
        .tx_on_s = section.quantity("tx_on", Unit::time, Range::between(0.0, 1.0), 0.0),
    };
    if (!std::has_single_bit(static_cast<unsigned>(chirp.n_samples)))
        section.fail("n_samples", "is not a power of two, so range bins would be padded ones",
                     "use 64, 128, 256 or 512");
    if (chirp.n_samples + chirp.settle_samples() < 8)
        section.fail("filter_latency_samples", "leaves fewer than 8 samples on the ramp",
                     "lessen it, or skip more samples");
    const double last_s = (chirp.settle_samples() + chirp.n_samples) / chirp.sample_rate_hz;
    if (last_s > chirp.ramp_end_s)
        section.fail("n_samples",
                     format("samples run to {:.4g} us, beyond the ramp's end at {:.4g} us",
                            last_s * 1e6, chirp.ramp_end_s * 1e6),
                     "take fewer samples, skip fewer, or end the ramp later");
    return chirp;
}

}  // namespace specula
