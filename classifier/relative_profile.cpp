#include "classifier/relative_profile.hpp"

#include <cmath>
#include <complex>

#include "classifier/extract_features.hpp"
#include "firmware/fw_range_profile.h"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"

namespace specula {

namespace {

using Complex = std::complex<double>;
constexpr std::size_t frames_per_turn = 64;

/// What turns the samples of a receiver into its spectrum at any place.
struct Transform {
    std::vector<double> window;  // (sample), times 2 / its sum
    std::size_t fft_size;        // a bin is a cycle in so many samples
};

Transform transform_for(const Dataset& dataset, const Descriptor& descriptor) {
    fw_window_shape shape;
    const auto n = static_cast<std::uint16_t>(dataset.n_samples);
    if (fw_window_find(descriptor.bins.window, n, &shape) != FW_OK)
        throw InputError(
            format("descriptor: the firmware has no such window of {} samples; use rect", n));
    Transform transform{.window = std::vector<double>(n), .fft_size = fw_range_fft_size(n)};
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t mirrored = std::min<std::size_t>(i, n - 1u - i);
        const double value = shape.half ? static_cast<double>(shape.half[mirrored]) : 1.0;
        transform.window[i] = value * 2.0 / static_cast<double>(shape.sum);
    }
    return transform;
}

/// (rx, sample): the mean over chirps, windowed.
std::vector<std::vector<double>> mean_rows(const Dataset& dataset, std::size_t frame,
                                           const Transform& transform) {
    const auto n_rx = static_cast<std::size_t>(dataset.n_rx);
    const auto n_chirps = static_cast<std::size_t>(dataset.n_chirps);
    const std::size_t n_samples = transform.window.size();
    const std::int16_t* code = dataset.adc.data() + frame * dataset.codes_per_frame();
    std::vector<std::vector<double>> rows(n_rx, std::vector<double>(n_samples));
    for (std::size_t chirp = 0; chirp < n_chirps; ++chirp)
        for (std::size_t rx = 0; rx < n_rx; ++rx)
            for (std::size_t i = 0; i < n_samples; ++i) rows[rx][i] += *code++;
    for (std::vector<double>& row : rows)
        for (std::size_t i = 0; i < n_samples; ++i)
            row[i] *= transform.window[i] / static_cast<double>(n_chirps);
    return rows;
}

/// The spectrum of a row at `bin`, whole or not.
Complex spectrum_at(const std::vector<double>& row, double bin, const Transform& transform) {
    const Complex turn = std::polar(1.0, -two_pi * bin / static_cast<double>(transform.fft_size));
    Complex phasor = 1.0, sum = 0.0;
    for (const double sample : row) {
        sum += sample * phasor;
        phasor *= turn;
    }
    return sum;
}

/// (frame): the bin of the strongest peak, between bins too.
std::vector<float> peak_bins(const Dataset& dataset, const Descriptor& descriptor, int threads) {
    const BinChoice search = descriptor.profile();
    fw_extract_config wide = descriptor.bins;
    wide.first_bin = static_cast<std::uint16_t>(search.first);
    wide.n_bins = static_cast<std::uint16_t>(search.count);
    const FeatureTable profiles = extract_features(dataset, wide, threads);
    std::vector<float> peaks;
    for (std::size_t i = 0; i < profiles.size(); ++i) {
        const fw_bins profile{.amplitude = profiles.row(i).data(),
                              .first_bin = wide.first_bin,
                              .n_bins = wide.n_bins};
        peaks.push_back(fw_peak_bin(&profile));
    }
    return peaks;
}

/// Calls `work(frame)` for all frames.
template <typename Work>
void for_each_frame(const Dataset& dataset, int threads, const Work& work) {
    const std::size_t n_turns = (dataset.n_frames() + frames_per_turn - 1) / frames_per_turn;
    for_each_index(n_turns, threads, [&](std::size_t turn) {
        const std::size_t end = std::min((turn + 1) * frames_per_turn, dataset.n_frames());
        for (std::size_t frame = turn * frames_per_turn; frame < end; ++frame) work(frame);
    });
}

void write_relative(const std::vector<std::vector<double>>& rows, double peak,
                    const Descriptor& descriptor, const Transform& transform,
                    std::span<float> out) {
    const std::size_t n_bins = descriptor.bins.n_bins;
    const double target = static_cast<double>(descriptor.normalise.target_bin);
    std::vector<Complex> mean(n_bins);
    double level = 0.0;
    const auto n_rx = static_cast<double>(rows.size());
    for (const std::vector<double>& row : rows) {
        const Complex at_peak = spectrum_at(row, peak, transform);
        level += std::abs(at_peak) / n_rx;
        if (std::abs(at_peak) == 0.0) continue;  // a receiver without any signal has no shape
        for (std::size_t k = 0; k < n_bins; ++k) {
            const double place = peak + static_cast<double>(descriptor.bins.first_bin + k) - target;
            mean[k] += spectrum_at(row, place, transform) / at_peak / n_rx;
        }
    }
    for (std::size_t k = 0; k < n_bins; ++k) {
        out[2 * k] = static_cast<float>(mean[k].real());
        out[2 * k + 1] = static_cast<float>(mean[k].imag());
    }
    constexpr double least_level = 1e-6;  // LSB: below all that a converter tells from silence
    out[2 * n_bins] = static_cast<float>(std::log(std::max(level * peak / target, least_level)));
}

}  // namespace

FeatureTable relative_profiles(const Dataset& dataset, const Descriptor& descriptor, int threads,
                               std::atomic<std::size_t>* frames_done) {
    const Transform transform = transform_for(dataset, descriptor);
    const std::vector<float> peaks = peak_bins(dataset, descriptor, threads);
    FeatureTable table;
    table.n_features = 2u * descriptor.bins.n_bins + 1u;
    table.features.resize(dataset.n_frames() * table.n_features);
    for_each_frame(dataset, threads, [&](std::size_t frame) {
        write_relative(
            mean_rows(dataset, frame, transform), static_cast<double>(peaks[frame]), descriptor,
            transform,
            std::span(table.features).subspan(frame * table.n_features, table.n_features));
        if (frames_done) ++*frames_done;
    });
    return table;
}

std::vector<float> angle_cues(const Dataset& dataset, const Descriptor& descriptor, int threads) {
    if (dataset.n_rx != descriptor.angle_rx)
        throw InputError(
            format("descriptor: angle {}: the frames have {} receivers; use angle {}, or none for "
                   "one",
                   descriptor.angle_rx, dataset.n_rx, dataset.n_rx));
    const Transform transform = transform_for(dataset, descriptor);
    const std::vector<float> peaks = peak_bins(dataset, descriptor, threads);
    const auto n_cues = static_cast<std::size_t>(2 * (descriptor.angle_rx - 1));
    std::vector<float> cues(dataset.n_frames() * n_cues);
    for_each_frame(dataset, threads, [&](std::size_t frame) {
        const auto rows = mean_rows(dataset, frame, transform);
        const double peak = static_cast<double>(peaks[frame]);
        const Complex reference = spectrum_at(rows[0], peak, transform);
        for (std::size_t rx = 1; rx < rows.size(); ++rx) {
            const Complex ratio = spectrum_at(rows[rx], peak, transform) * std::conj(reference);
            const double size = std::abs(ratio);
            if (size == 0.0) continue;  // no signal, no angle: (0, 0)
            cues[frame * n_cues + 2 * (rx - 1)] = static_cast<float>(ratio.real() / size);
            cues[frame * n_cues + 2 * (rx - 1) + 1] = static_cast<float>(ratio.imag() / size);
        }
    });
    return cues;
}

}  // namespace specula
