#pragma once

#include <cmath>
#include <complex>
#include <span>
#include <string>
#include <vector>

#include "sim/core/constants.hpp"

namespace specula {

/// Symmetric windows as the reference cases name them: "rect", "hann", "blackman".
inline double window_at(const std::string& name, std::size_t i, std::size_t n) {
    const double turn = two_pi * static_cast<double>(i) / (static_cast<double>(n) - 1.0);
    if (name == "hann") return 0.5 - 0.5 * std::cos(turn);
    if (name == "blackman") return 0.42 - 0.5 * std::cos(turn) + 0.08 * std::cos(2.0 * turn);
    return 1.0;
}

/// Amplitude spectrum, written out: |Sum s w exp(-j 2 pi k i / n)| 2 / Sum w at bin k, which need
/// not be whole.
inline double amplitude_at(std::span<const double> samples, const std::string& window, double bin) {
    std::complex<double> sum = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double w = window_at(window, i, samples.size());
        sum += samples[i] * w *
               std::polar(1.0, -two_pi * bin * static_cast<double>(i) /
                                   static_cast<double>(samples.size()));
        weight += w;
    }
    return std::abs(sum) * 2.0 / weight;
}

}  // namespace specula
