#include "tools/sweep/echo_profile.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/fw_window.h"
#include "sim/core/constants.hpp"
#include "sim/signal/dechirp.hpp"

namespace specula {

namespace {

struct Window {
    std::vector<double> value;  ///< (sample)
    double sum = 0.0;
};

Window window_of(int n_samples) {
    Window window{std::vector<double>(static_cast<std::size_t>(n_samples), 1.0),
                  static_cast<double>(n_samples)};
    fw_window_shape shape;
    if (fw_window_find(FW_WINDOW_BLACKMAN, static_cast<std::uint16_t>(n_samples), &shape) != FW_OK)
        return window;
    const auto n = static_cast<std::size_t>(n_samples);
    for (std::size_t i = 0; i < n; ++i)
        window.value[i] = static_cast<double>(shape.half[std::min(i, n - 1 - i)]);
    window.sum = static_cast<double>(shape.sum);
    return window;
}

std::vector<Complex> turns_of(std::size_t n) {
    std::vector<Complex> turns;
    for (std::size_t i = 0; i < n; ++i)
        turns.push_back(std::polar(1.0, -two_pi * static_cast<double>(i) / static_cast<double>(n)));
    return turns;
}

}  // namespace

EchoProfile echo_profile(const Channel& channel, const Radar& radar) {
    const auto n = static_cast<std::size_t>(radar.chirp.n_samples);
    const BeatSignal beat = dechirp(channel, radar.chirp);
    const Window window = window_of(radar.chirp.n_samples);
    const std::vector<Complex> turns = turns_of(n);
    const double scale =
        2.0 / window.sum * radar.amplitude_lsb(radar.tx_power_dbm) / static_cast<double>(beat.n_rx);
    EchoProfile profile;
    profile.bin_lsb.assign(n / 2, 0.0);
    for (int rx = 0; rx < beat.n_rx; ++rx) {
        const Complex* samples = beat.of_rx(rx) + radar.chirp.settle_samples();
        for (std::size_t k = 0; k < n / 2; ++k) {
            Complex sum = 0.0;
            for (std::size_t i = 0; i < n; ++i)
                sum += window.value[i] * samples[i].real() * turns[k * i % n];
            profile.bin_lsb[k] += scale * std::abs(sum);
        }
    }
    const auto peak = std::max_element(profile.bin_lsb.begin(), profile.bin_lsb.end());
    profile.peak_bin = static_cast<int>(peak - profile.bin_lsb.begin());
    double power = 0.0, moment = 0.0;
    for (std::size_t k = 0; k < n / 2; ++k) {
        power += profile.bin_lsb[k] * profile.bin_lsb[k];
        moment += static_cast<double>(k) * profile.bin_lsb[k] * profile.bin_lsb[k];
    }
    profile.centroid_bin = power > 0.0 ? moment / power : 0.0;
    return profile;
}

}  // namespace specula
