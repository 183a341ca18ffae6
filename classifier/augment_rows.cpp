#include <algorithm>
#include <cmath>
#include <complex>

#include "classifier/augment.hpp"
#include "classifier/step_draw.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// sin(pi x) / (pi x)
double sinc(double x) {
    return std::abs(x) < 1e-9 ? 1.0 : std::sin(pi * x) / (pi * x);
}

/// Amplitude that a tone x bins away leaves in a bin behind a Blackman window, 1 at x = 0.
/// @eq PHYSICS.md#range-profile
double blackman_line(double x) {
    return sinc(x) + 0.25 / 0.42 * (sinc(x - 1.0) + sinc(x + 1.0)) +
           0.04 / 0.42 * (sinc(x - 2.0) + sinc(x + 2.0));
}

/// Deviation of either part of a bin per LSB of white noise in the samples; 1 where their number is
/// not known, and noise is then that of the features themselves.
double bin_noise(const RadarView& radar) {
    constexpr double blackman = 1.8584;  // sqrt(2 * 0.3046) / 0.42: rms and mean of the window
    return radar.n_samples > 0 ? blackman / std::sqrt(radar.n_samples) : 1.0;
}

/// A row as mean amplitude of `n_rows` phasors, to each of which something is added.
template <typename Added>
void add_phasors(std::span<float> row, int n_rows, const Added& added) {
    std::vector<double> sum(row.size(), 0.0);
    for (int each = 0; each < n_rows; ++each)
        for (std::size_t k = 0; k < row.size(); ++k)
            sum[k] += std::abs(static_cast<double>(row[k]) + added(each, k));
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = static_cast<float>(sum[k] / n_rows);
}

void add_noise(std::span<float> row, const RadarView& radar, double sd_lsb, Stream& stream) {
    const double sd = sd_lsb * bin_noise(radar);
    add_phasors(row, radar.n_rows, [&](int, std::size_t) {
        const double re = sd * stream.normal();
        return std::complex<double>(re, sd * stream.normal());
    });
}

void add_tone(std::span<float> row, const RadarView& radar, const Tone& tone, Stream& stream) {
    std::vector<std::complex<double>> phasor;
    for (int each = 0; each < radar.n_rows; ++each)
        phasor.push_back(std::polar(tone.amplitude_lsb, two_pi * stream.uniform()));
    add_phasors(row, radar.n_rows, [&](int each, std::size_t k) {
        const double bin = radar.first_bin + static_cast<double>(k);
        return phasor[static_cast<std::size_t>(each)] * blackman_line(bin - tone.bin);
    });
}

/// The row between its bins: Lagrange's polynomial through the six nearest, ends held.
double value_at(const std::vector<float>& row, double at) {
    constexpr std::ptrdiff_t n_points = 6;
    at = std::clamp(at, 0.0, static_cast<double>(row.size() - 1));
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(std::floor(at)) - n_points / 2 + 1;
    double value = 0.0;
    for (std::ptrdiff_t i = first; i < first + n_points; ++i) {
        double weight = 1.0;
        for (std::ptrdiff_t j = first; j < first + n_points; ++j)
            if (j != i) weight *= (at - static_cast<double>(j)) / static_cast<double>(i - j);
        const auto held = std::clamp<std::ptrdiff_t>(i, 0, std::ssize(row) - 1);
        value += weight * static_cast<double>(row[static_cast<std::size_t>(held)]);
    }
    return std::max(0.0, value);
}

void move_row(std::span<float> row, const RadarView& radar, const Move& move) {
    constexpr double leakage_end = 5.0;  // bins below hold it, behind a Blackman window, and stay
    const std::vector<float> before(row.begin(), row.end());
    for (std::size_t k = 0; k < row.size(); ++k) {
        const double bin = radar.first_bin + static_cast<double>(k);
        if (bin < leakage_end) continue;
        const double from = std::max(leakage_end, bin - move.bins);
        const double passed = move.keeps_level ? 1.0 : std::abs(high_pass_ratio(radar, from, bin));
        row[k] = static_cast<float>(value_at(before, from - radar.first_bin) * move.level * passed);
    }
}

}  // namespace

std::vector<double> augment_row(std::span<float> row, const Augmentation& how, double range_m,
                                const StreamKey& key) {
    const RadarView& radar = how.radar;
    if (range_m < 0.0 && needs_range(how)) {
        const auto strongest = std::max_element(row.begin(), row.end()) - row.begin();
        range_m = (radar.first_bin + static_cast<double>(strongest)) * radar.bin_m;
    }
    std::vector<double> drawn;
    for (std::size_t i = 0; i < how.steps.size(); ++i) {
        StepDraw draw(how.steps[i], radar, {.key = key, .step = i});
        drawn.push_back(draw.value());
        if (draw.is<NoiseStep>()) add_noise(row, radar, draw.value(), draw.stream());
        if (draw.is<GainStep>())
            for (float& value : row)
                value = static_cast<float>(value * std::pow(10.0, draw.value() / 20.0));
        if (const auto tone = draw.tone()) add_tone(row, radar, *tone, draw.stream());
        if (const auto move = draw.move(range_m)) {
            move_row(row, radar, *move);
            range_m += draw.value();
        }
    }
    return drawn;
}

FeatureTable augmented(const FeatureTable& rows, const Augmentation& how, const StreamKey& key) {
    FeatureTable changed = rows;
    constexpr double unknown_range_m = -1.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        StreamKey own = key;
        own.item += static_cast<std::uint32_t>(i);
        augment_row(std::span(changed.features).subspan(i * rows.n_features, rows.n_features), how,
                    unknown_range_m, own);
    }
    return changed;
}

}  // namespace specula
