#include "tools/specula/learning.hpp"

#include <algorithm>
#include <fstream>

#include "classifier/looks.hpp"
#include "classifier/same_measurement.hpp"
#include "classifier/training_rows.hpp"
#include "sim/core/document.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/specula/bin_choice.hpp"
#include "tools/study/progress.hpp"

namespace specula {

TrainOptions training_options(const Learning& learning) {
    TrainOptions options = learning.options;
    if (learning.logistic) options.hidden.clear();
    const auto& names = schedule_names();
    const auto place = std::ranges::find(names, learning.schedule) - names.begin();
    options.schedule = static_cast<Schedule>(place);
    options.precision = learning.precision == "float64" ? Precision::float64 : Precision::float32;
    return options;
}

Descriptor chosen_descriptor(const Learning& learning, const Dataset& dataset) {
    return learning.descriptor.empty() ? descriptor_for(dataset, parse_bin_choice(learning.bins))
                                       : parse_descriptor(learning.descriptor);
}

std::vector<std::size_t> first_frames(const Dataset& dataset, const Descriptor& descriptor) {
    FeatureTable frames;
    for (const Truth& truth : dataset.truth) {
        frames.label.push_back(truth.label);
        frames.world.push_back(truth.world);
        frames.session.push_back(truth.session);
    }
    if (descriptor.looks > 1)
        return first_rows(frames, {.count = static_cast<std::size_t>(descriptor.looks)});
    std::vector<std::size_t> all(frames.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

FeatureTable described(const Dataset& dataset, const Descriptor& descriptor, int threads) {
    constexpr std::size_t soon_done = 20'000;  // frames, a second's work for one processor
    if (dataset.n_frames() < soon_done) return describe(dataset, descriptor, threads);
    Progress progress("Describing", "frames", dataset.n_frames());
    return describe(dataset, descriptor, threads, &progress.done());
}

void expect_measured_for(const Model& model, const Dataset& dataset, const Catalogue& catalogue) {
    if (!model.measurement || dataset.adc.empty()) return;
    expect_same_measurement(*model.measurement, dataset, known_radar(dataset, catalogue));
}

Dataset dataset_from(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (in.get() == '{')
        throw InputError(file.string() +
                         ": is JSON such as a model, not a dataset; a dataset (.h5) belongs here");
    return read_dataset(file);
}

void count_classes_as(const Model& model, const std::string& file, Dataset& dataset) {
    for (Truth& truth : dataset.truth) {
        const auto found = std::ranges::find(model.class_names, dataset.class_names[truth.label]);
        if (found == model.class_names.end())
            throw InputError(format(
                "class_names: \"{}\" is no class of {}; the model knows {}, the data name {}",
                dataset.class_names[truth.label], file, quoted_list(model.class_names),
                quoted_list(dataset.class_names)));
        truth.label = static_cast<std::uint8_t>(found - model.class_names.begin());
    }
    dataset.class_names = model.class_names;
}

void expect_heeded(const std::vector<std::string>& given, const Learning& learning,
                   const std::string& holdout) {
    const auto is_given = [&](const char* option) {
        return std::ranges::find(given, option) != given.end();
    };
    if (is_given("--held-out") && holdout.empty() && learning.options.patience == 0)
        throw InputError(
            "--held-out: goes with --patience, or of specula train with --holdout session, and "
            "holds nothing out alone; add one or leave it out");
    if (is_given("--kernel") && learning.options.convolution.empty())
        throw InputError("--kernel: goes with --convolution; add it or leave --kernel out");
}

std::vector<std::string> feature_names_of(const Dataset& dataset, const Descriptor& descriptor) {
    if (descriptor.extractor != "columns") return {};
    const std::size_t n = dataset.feature_names.size();
    const std::size_t first = std::min<std::size_t>(descriptor.bins.first_bin, n);
    const std::size_t count = std::min<std::size_t>(descriptor.bins.n_bins, n - first);
    const auto begin = dataset.feature_names.begin() + static_cast<std::ptrdiff_t>(first);
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

namespace {

/// Columns of another name or in another order would be scored in silence.
void expect_same_features(const Model& model, const Dataset& dataset,
                          const Descriptor& descriptor) {
    const auto names = feature_names_of(dataset, descriptor);
    if (model.feature_names.empty() || names.size() != model.feature_names.size()) return;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] != model.feature_names[i])
            throw InputError(
                format("features: column {} is \"{}\", and the model was trained on \"{}\" there; "
                       "use data with the same columns in the same order",
                       descriptor.bins.first_bin + i, names[i], model.feature_names[i]));
}

}  // namespace

FeatureTable rows_for(const Model& model, const Dataset& dataset, int threads) {
    const Descriptor descriptor = descriptor_of(model);
    expect_same_features(model, dataset, descriptor);
    const FeatureTable rows = described(dataset, descriptor, threads);
    if (rows.n_features != model.n_features())
        throw InputError(
            format("descriptor: gives {} features and the model takes {}; use frames like those "
                   "it was trained on",
                   rows.n_features, model.n_features()));
    check_finite(rows);
    return rows;
}

}  // namespace specula
