#include "classifier/descriptor.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "classifier/extract_features.hpp"
#include "classifier/looks.hpp"
#include "classifier/normalised_bins.hpp"
#include "classifier/peak_shape.hpp"
#include "classifier/relative_profile.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr int default_windows = 12;

bool has_window(int n_samples) {
    return n_samples == 64 || n_samples == 128 || n_samples == 256 || n_samples == 512;
}

void check_bins(const BinChoice& choice, int n_available, const char* what) {
    if (choice.first < 0 || choice.count < 1 || choice.first + choice.count > n_available)
        throw InputError(format("bins {}:{}: there are {} {}; choose among them", choice.first,
                                choice.count, n_available, what));
}

/// Mean magnitude over chirps, receivers and the samples of each window.
FeatureTable range_windows(const Dataset& dataset, const Descriptor& descriptor) {
    const auto n_samples = static_cast<std::size_t>(dataset.n_samples);
    const std::size_t n_windows = descriptor.bins.n_bins;
    const std::size_t n_rows = dataset.codes_per_frame() / n_samples;
    FeatureTable table;
    table.features.reserve(dataset.n_frames() * n_windows);
    for (std::size_t i = 0; i < dataset.n_frames(); ++i)
        for (std::size_t w = 0; w < n_windows; ++w) {
            const std::size_t begin = w * n_samples / n_windows;
            const std::size_t end = (w + 1) * n_samples / n_windows;
            double sum = 0.0;
            for (std::size_t row = 0; row < n_rows; ++row)
                for (std::size_t n = begin; n < end; ++n) {
                    const std::size_t at = i * dataset.codes_per_frame() + row * n_samples + n;
                    const double re = dataset.adc[at];
                    const double im =
                        dataset.adc_quadrature.empty() ? 0.0 : dataset.adc_quadrature[at];
                    sum += std::sqrt(re * re + im * im);
                }
            table.features.push_back(
                static_cast<float>(sum / static_cast<double>((end - begin) * n_rows)));
        }
    return table;
}

FeatureTable columns(const Dataset& dataset, const Descriptor& descriptor) {
    const std::size_t n = dataset.feature_names.size();
    FeatureTable table;
    for (std::size_t i = 0; i < dataset.n_frames(); ++i)
        for (std::size_t k = 0; k < descriptor.bins.n_bins; ++k)
            table.features.push_back(
                static_cast<float>(dataset.features[i * n + descriptor.bins.first_bin + k]));
    if (!std::ranges::all_of(table.features, [](float value) { return std::isfinite(value); }))
        throw InputError("features: some are too large for a float; scale them down");
    return table;
}

/// The kind of data that an extractor makes features of must be there.
void check_kind(const Dataset& dataset, const std::string& extractor) {
    const auto refuse = [&](const std::string& problem) {
        throw InputError(
            format("{}: {}; use data that hold what the features are made of, or "
                   "features made of what is there",
                   extractor, problem));
    };
    if (extractor == "columns") {
        if (dataset.feature_names.empty())
            refuse("takes recorded features (/features), and the dataset holds none");
        return;
    }
    const bool wants_range = extractor == "range_windows";
    const std::string wanted = wants_range ? "samples along range" : "beat samples";
    if (dataset.adc.empty()) refuse(format("takes {} (/adc), and the dataset holds none", wanted));
    if (wants_range != (dataset.sample_axis == SampleAxis::range))
        refuse(format("takes {}, and /adc holds {}", wanted,
                      wants_range ? "beat samples" : "samples along range"));
}

void check_fit(const Dataset& dataset, const Descriptor& descriptor) {
    check_kind(dataset, descriptor.extractor);
    const BinChoice choice{descriptor.bins.first_bin, descriptor.bins.n_bins};
    if (descriptor.extractor == "columns") {
        check_bins(choice, static_cast<int>(dataset.feature_names.size()), "features");
        return;
    }
    const bool is_range = dataset.sample_axis == SampleAxis::range;
    if (!is_range && !dataset.adc_quadrature.empty())
        throw InputError(
            "the codes are complex, and the firmware takes real ones only; export "
            "them and import features");
    const int n_available = is_range ? dataset.n_samples : dataset.n_samples / 2;
    check_bins(choice, n_available, is_range ? "samples" : "range bins");
    check_bins(descriptor.profile(), n_available, "range bins to search");
}

}  // namespace

std::size_t Descriptor::n_features() const {
    std::size_t n = bins.n_bins;
    if (is_relative()) n = 2 * n + 1;
    if (angle_rx > 0) n += 2 * (static_cast<std::size_t>(angle_rx) - 1);
    return spread ? 2 * n : n;
}

Descriptor descriptor_for(const Dataset& dataset, const std::optional<BinChoice>& choice) {
    Descriptor descriptor;
    BinChoice bins{FW_DEFAULT_FIRST_BIN, FW_DEFAULT_N_BINS};
    if (dataset.adc.empty()) {
        descriptor.extractor = "columns";
        bins = {0, static_cast<int>(dataset.feature_names.size())};
    } else if (dataset.sample_axis == SampleAxis::range) {
        descriptor.extractor = "range_windows";
        bins = {0, default_windows};
    }
    check_kind(dataset, descriptor.extractor);
    if (choice) bins = *choice;
    check_bins(bins, 65535, "at most");
    descriptor.bins.first_bin = static_cast<std::uint16_t>(bins.first);
    descriptor.bins.n_bins = static_cast<std::uint16_t>(bins.count);
    if (!has_window(dataset.n_samples)) descriptor.bins.window = FW_WINDOW_RECT;
    check_fit(dataset, descriptor);
    return descriptor;
}

Descriptor descriptor_of(const Model& model) {
    Descriptor descriptor;
    descriptor.extractor = model.extractor;
    descriptor.bins.n_bins = static_cast<std::uint16_t>(model.input_mean.size());
    for (const auto& [what, value] : model.provenance) {
        if (what != "descriptor") continue;
        try {
            descriptor = parse_descriptor(value);
        } catch (const InputError& error) {
            throw InputError(format("provenance: {}", error.what()));
        }
        if (descriptor.n_features() != model.input_mean.size())
            throw InputError(
                format("provenance: descriptor = \"{}\": is not one of this model's "
                       "{} inputs; train the model again",
                       value, model.input_mean.size()));
    }
    return descriptor;
}

namespace {

FeatureTable frame_features(const Dataset& dataset, const Descriptor& descriptor, int threads,
                            std::atomic<std::size_t>* done) {
    if (descriptor.extractor == "range_bins")
        return descriptor.uses_peak() || descriptor.normalise.logarithm || descriptor.unit_energy
                   ? normalised_bins(dataset, descriptor, threads, done)
                   : extract_features(dataset, descriptor.bins, threads, done);
    if (descriptor.extractor == "relative_profile")
        return relative_profiles(dataset, descriptor, threads, done);
    if (descriptor.extractor == "peak_shape") return peak_shapes(dataset, descriptor, threads);
    FeatureTable table = descriptor.extractor == "columns" ? columns(dataset, descriptor)
                                                           : range_windows(dataset, descriptor);
    table.n_features = descriptor.bins.n_bins;
    return table;
}

/// Puts more features behind those of every row.
void append_columns(const std::vector<float>& more, FeatureTable& table) {
    const std::size_t n_rows = table.features.size() / table.n_features;
    const std::size_t n_more = more.size() / n_rows;
    std::vector<float> features;
    features.reserve(table.features.size() + more.size());
    for (std::size_t i = 0; i < n_rows; ++i) {
        const auto row = std::span(table.features).subspan(i * table.n_features, table.n_features);
        features.insert(features.end(), row.begin(), row.end());
        const auto added = std::span(more).subspan(i * n_more, n_more);
        features.insert(features.end(), added.begin(), added.end());
    }
    table.n_features += n_more;
    table.features = std::move(features);
}

}  // namespace

FeatureTable describe(const Dataset& dataset, const Descriptor& descriptor, int threads,
                      std::atomic<std::size_t>* frames_done) {
    check_fit(dataset, descriptor);
    FeatureTable table = frame_features(dataset, descriptor, threads, frames_done);
    if (descriptor.angle_rx > 0) append_columns(angle_cues(dataset, descriptor, threads), table);
    table.extractor = descriptor.extractor;
    table.class_names = dataset.class_names;
    table.label.clear();
    table.world.clear();
    table.session.clear();
    for (const Truth& truth : dataset.truth) {
        table.label.push_back(truth.label);
        table.world.push_back(truth.world);
        table.session.push_back(truth.session);
    }
    if (descriptor.looks < 2) return table;
    return combine_looks(
        table, {.count = static_cast<std::size_t>(descriptor.looks), .spread = descriptor.spread});
}

}  // namespace specula
