#pragma once

/// What the firmware should compute, said again in double and without its tricks.

#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "firmware/fw_window.h"

namespace oracle {

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Half the gap between 1 and the next float: the relative error of one float operation.
inline constexpr double unit_roundoff = 0x1p-24;

/// Relative error of a float transform of n values in the 2-norm (Higham 2002, theorem 24.2:
/// log2(n) stages of u + gamma_4 (sqrt 2 + u)), and one more stage for the splitting of a real one.
inline double transform_error(std::size_t n) {
    return 6.7 * unit_roundoff * (std::log2(static_cast<double>(n)) + 1);
}

/// The definition of the discrete Fourier transform.
inline std::vector<std::complex<double>> transform(const std::vector<std::complex<double>>& x) {
    const auto n = x.size();
    std::vector<std::complex<double>> spectrum(n);
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t i = 0; i < n; ++i) {
            const double turns = static_cast<double>(i * k % n) / static_cast<double>(n);
            spectrum[k] += x[i] * std::polar(1.0, -2 * std::numbers::pi * turns);
        }
    }
    return spectrum;
}

inline double norm(const std::vector<std::complex<double>>& x) {
    double energy = 0;
    for (const auto& value : x) energy += std::norm(value);
    return std::sqrt(energy);
}

/// The textbook windows.
inline double window(fw_window kind, std::size_t i, std::size_t n) {
    const double x = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n - 1);
    if (kind == FW_WINDOW_HANN) return 0.5 - 0.5 * std::cos(x);
    if (kind == FW_WINDOW_BLACKMAN) return 0.42 - 0.5 * std::cos(x) + 0.08 * std::cos(2 * x);
    return 1;
}

/// Codes of a loud random signal.
inline std::vector<std::int16_t> random_codes(std::size_t n, unsigned seed) {
    std::mt19937 generator(seed);
    std::vector<std::int16_t> codes(n);
    for (auto& code : codes) code = static_cast<std::int16_t>(generator() % 65536 - 32768);
    return codes;
}

/// Values in [-1, 1).
inline std::vector<float> random_values(std::size_t n, unsigned seed) {
    std::mt19937 generator(seed);
    std::vector<float> values(n);
    for (auto& value : values) value = static_cast<float>(generator() >> 8) * 0x1p-23F - 1;
    return values;
}

}  // namespace oracle
