#include "tools/validate/formulas/spectrum.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "firmware/fw_window.h"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/validate/fields.hpp"

namespace specula {

namespace {

double defined_window(fw_window window, double x) {
    switch (window) {
        case FW_WINDOW_RECT:
            break;
        case FW_WINDOW_HANN:
            return 0.5 - 0.5 * std::cos(x);
        case FW_WINDOW_BLACKMAN:
            return 0.42 - 0.5 * std::cos(x) + 0.08 * std::cos(2.0 * x);
    }
    return 1.0;
}

std::optional<fw_window> named(const std::string& name) {
    if (name == "rect") return FW_WINDOW_RECT;
    if (name == "hann") return FW_WINDOW_HANN;
    if (name == "blackman") return FW_WINDOW_BLACKMAN;
    return std::nullopt;
}

}  // namespace

std::vector<double> window_values(const std::string& name, int n_samples) {
    const auto window = named(name);
    if (!window) throw NotComputable(format("does not know the window \"{}\"", name));
    const auto n = static_cast<std::size_t>(n_samples);
    std::vector<double> values(n, 1.0);
    fw_window_shape shape;
    if (n_samples <= std::numeric_limits<std::uint16_t>::max() &&
        fw_window_find(*window, static_cast<std::uint16_t>(n_samples), &shape) == FW_OK) {
        for (std::size_t i = 0; shape.half != nullptr && i < n / 2; ++i)
            values[i] = values[n - 1 - i] = static_cast<double>(shape.half[i]);
        return values;
    }
    for (std::size_t i = 0; n > 1 && i < n; ++i)
        values[i] = defined_window(
            *window, two_pi * static_cast<double>(i) / static_cast<double>(n - 1));
    return values;
}

double noise_bandwidth_bins(std::span<const double> window) {
    double sum = 0.0, squares = 0.0;
    for (const double value : window) {
        sum += value;
        squares += value * value;
    }
    return static_cast<double>(window.size()) * squares / (sum * sum);
}

namespace {

double sum_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

/// Horner's scheme: one sine and cosine per bin.
template <typename Sample>
Complex polynomial(std::span<const Sample> samples, const Transform& transform, int k) {
    SPECULA_EXPECT(samples.size() == transform.window.size());
    const Complex turn = std::polar(1.0, -two_pi * k / transform.size);
    Complex sum = 0.0;
    for (std::size_t i = samples.size(); i-- > 0;)
        sum = sum * turn + samples[i] * transform.window[i];
    return sum;
}

}  // namespace

Complex bin_of(std::span<const Complex> samples, const Transform& transform, int k) {
    return polynomial(samples, transform, k) / sum_of(transform.window);
}

std::vector<double> real_amplitudes(std::span<const double> samples, const Transform& transform,
                                    int first, int last) {
    const double scale = 2.0 / sum_of(transform.window);
    std::vector<double> amplitudes;
    for (int k = first; k <= last; ++k)
        amplitudes.push_back(scale * std::abs(polynomial(samples, transform, k)));
    return amplitudes;
}

std::vector<double> levels_db(std::span<const double> amplitudes) {
    std::vector<double> levels;
    for (const double amplitude : amplitudes) levels.push_back(20.0 * std::log10(amplitude));
    return levels;
}

std::vector<int> local_maxima(std::span<const double> amplitudes, double least) {
    std::vector<int> found;
    for (std::size_t i = 1; i + 1 < amplitudes.size(); ++i)
        if (amplitudes[i] > least && amplitudes[i] > amplitudes[i - 1] &&
            amplitudes[i] >= amplitudes[i + 1])
            found.push_back(static_cast<int>(i));
    return found;
}

}  // namespace specula
