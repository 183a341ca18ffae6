#include "tools/dataset/frame_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "classifier/descriptor.hpp"
#include "firmware/fw_fft.h"

namespace specula {

namespace {

constexpr std::size_t first_echo_bin = 4, echo_half_width = 2, fewest_noise_bins = 4;

/// Mean over chirps and RX of |transform of I + jQ| / N, lower half of the bins.
FrameProfiles complex_profiles(const Dataset& dataset) {
    const auto n = static_cast<std::size_t>(dataset.n_samples);
    FrameProfiles profiles{.n_values = n / 2, .rows = {}};
    std::vector<float> data(2 * n);
    if (fw_fft_complex(data.data(), static_cast<std::uint16_t>(n)) != FW_OK) return {};
    profiles.rows.resize(dataset.n_frames() * profiles.n_values);
    const std::size_t rows = dataset.codes_per_frame() / n;
    for (std::size_t row = 0; row < dataset.n_frames() * rows; ++row) {
        for (std::size_t i = 0; i < n; ++i) {
            data[2 * i] = dataset.adc[row * n + i];
            data[2 * i + 1] = dataset.adc_quadrature[row * n + i];
        }
        fw_fft_complex(data.data(), static_cast<std::uint16_t>(n));
        float* const out = &profiles.rows[row / rows * profiles.n_values];
        for (std::size_t k = 0; k < profiles.n_values; ++k)
            out[k] += std::hypot(data[2 * k], data[2 * k + 1]) / static_cast<float>(n * rows);
    }
    return profiles;
}

/// Those that the file holds itself, mean over RX.
FrameProfiles stored_profiles(const Dataset& dataset) {
    FrameProfiles profiles{.n_values = static_cast<std::size_t>(dataset.n_profile_bins),
                           .rows = {}};
    profiles.rows.resize(dataset.n_frames() * profiles.n_values);
    const auto n_rx = static_cast<std::size_t>(dataset.n_rx);
    for (std::size_t i = 0; i < dataset.profile.size(); ++i) {
        const std::size_t row = i / profiles.n_values;
        profiles.rows[row / n_rx * profiles.n_values + i % profiles.n_values] +=
            dataset.profile[i] / static_cast<float>(n_rx);
    }
    return profiles;
}

}  // namespace

std::string profile_axis(const Dataset& dataset) {
    if (dataset.n_samples == 0) return dataset.n_profile_bins > 0 ? "range bin" : "feature";
    return dataset.sample_axis == SampleAxis::range ? "sample" : "range bin";
}

FrameProfiles frame_profiles(const Dataset& dataset, int threads) {
    if (dataset.n_samples == 0 && dataset.n_profile_bins > 0) return stored_profiles(dataset);
    const bool is_beat = dataset.sample_axis == SampleAxis::beat;
    if (dataset.n_samples > 0 && is_beat && !dataset.adc_quadrature.empty())
        return complex_profiles(dataset);
    if (dataset.n_samples > 0 && dataset.n_samples < FW_MIN_SAMPLES && is_beat) return {};
    const int n_values = dataset.n_samples == 0 ? static_cast<int>(dataset.feature_names.size())
                         : is_beat              ? dataset.n_samples / 2
                                                : dataset.n_samples;
    if (n_values < 1 || (is_beat && dataset.n_samples > FW_MAX_SAMPLES)) return {};
    FeatureTable table =
        describe(dataset, descriptor_for(dataset, BinChoice{0, n_values}), threads);
    return {.n_values = table.n_features, .rows = std::move(table.features)};
}

double profile_snr_db(std::span<const float> profile, double echo_bin) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const std::size_t n = profile.size();
    if (n < 2 * fewest_noise_bins) return unknown;
    std::size_t begin = first_echo_bin, end = n;
    if (echo_bin >= 0.0) {
        const auto centre = static_cast<std::size_t>(std::lround(echo_bin));
        begin = centre > echo_half_width ? centre - echo_half_width : 0;
        end = std::min(n, centre + echo_half_width + 1);
    }
    if (begin >= end) return unknown;
    const float peak = *std::max_element(profile.begin() + static_cast<std::ptrdiff_t>(begin),
                                         profile.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<float> noise(profile.begin() + static_cast<std::ptrdiff_t>(n / 2), profile.end());
    const auto middle = noise.begin() + static_cast<std::ptrdiff_t>(noise.size() / 2);
    std::nth_element(noise.begin(), middle, noise.end());
    if (!(*middle > 0.0f && peak > 0.0f)) return unknown;
    return 20.0 * std::log10(static_cast<double>(peak) / static_cast<double>(*middle));
}

}  // namespace specula
