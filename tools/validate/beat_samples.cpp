#include "tools/validate/beat_samples.hpp"

#include <cmath>

#include "sim/channel/path.hpp"
#include "sim/core/constants.hpp"
#include "sim/signal/dechirp.hpp"

namespace specula {

namespace {

BeatSignal beat_of(const Chirp& chirp, const PointEcho& echo) {
    const FrequencyComb comb = comb_of(chirp);
    Channel channel = silent_channel(1, comb);
    add_path(channel, comb,
             {.rx = 0, .length_m = 2.0 * echo.range_m, .transfer = echo.amplitude});
    channel.reference_path_m = 2.0 * echo.range_m;
    return dechirp(channel, chirp);
}

/// The beat at the one frequency of a chirp that stands still.
Complex still_beat(double frequency_hz, double range_m) {
    const Chirp still{.start_hz = frequency_hz,
                      .slope_hz_s = 0.0,
                      .n_samples = 1,
                      .skip_samples = 0,
                      .filter_latency_samples = 0};
    return beat_of(still, {.range_m = range_m}).analytic.front();
}

}  // namespace

std::vector<double> beat_samples(const Chirp& chirp, std::span<const PointEcho> echoes) {
    std::vector<double> sum(static_cast<std::size_t>(chirp.n_samples), 0.0);
    for (const PointEcho& echo : echoes) {
        const BeatSignal beat = beat_of(chirp, echo);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += beat.analytic[i].real();
    }
    return sum;
}

double beat_phase_rad(const Displacement& displacement) {
    constexpr double begin_m = 0.45;
    const double eighth_m = 0.125 * speed_of_light_m_s / displacement.frequency_hz;
    const double n_steps = std::max(1.0, std::ceil(std::abs(displacement.shift_m) / eighth_m));
    double phase_rad = 0.0;
    Complex before = still_beat(displacement.frequency_hz, begin_m);
    for (double step = 1.0; step <= n_steps; ++step) {
        const Complex after = still_beat(displacement.frequency_hz,
                                         begin_m + displacement.shift_m * (step / n_steps));
        phase_rad += std::arg(after * std::conj(before));
        before = after;
    }
    return phase_rad;
}

}  // namespace specula
