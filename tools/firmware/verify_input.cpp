#include "tools/firmware/verify_input.hpp"

#include <algorithm>

#include "classifier/descriptor.hpp"
#include "classifier/model_blob.hpp"
#include "classifier/model_file.hpp"
#include "classifier/same_measurement.hpp"
#include "classifier/train.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/generate.hpp"
#include "sim/recording/import_recording.hpp"
#include "tools/firmware/asked_descriptor.hpp"
#include "tools/firmware/verification.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr int arbitrary_classes = 5;
constexpr int training_epochs = 20;

/// The training recordings of the paper's experiment in one world.
Dataset simulate_frames(const Experiment& experiment, const Catalogue& catalogue, int threads) {
    const Bench bench = bench_of(experiment, catalogue.materials);
    Progress progress("Simulating", "sessions",
                      session_count(experiment.training, experiment.population, 1));
    return generate(bench, experiment.training, 1, threads, &progress.done());
}

/// At most n frames, evenly over all.
Dataset thinned(const Dataset& dataset, std::size_t n) {
    if (dataset.n_frames() <= n) return dataset;
    Dataset few = dataset;
    few.truth.clear();
    few.adc.clear();
    const std::size_t codes = dataset.codes_per_frame();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t frame = i * dataset.n_frames() / n;
        few.truth.push_back(dataset.truth[frame]);
        const auto begin = dataset.adc.begin() + static_cast<std::ptrdiff_t>(frame * codes);
        few.adc.insert(few.adc.end(), begin, begin + static_cast<std::ptrdiff_t>(codes));
    }
    return few;
}

bool has_two_classes(const Dataset& dataset) {
    return std::any_of(dataset.truth.begin(), dataset.truth.end(), [&](const Truth& truth) {
        return truth.label != dataset.truth.front().label;
    });
}

fw_window window_for(int n_samples) {
    fw_window_shape shape;
    const auto n = static_cast<std::uint16_t>(n_samples);
    return fw_window_find(FW_WINDOW_BLACKMAN, n, &shape) == FW_OK ? FW_WINDOW_BLACKMAN
                                                                  : FW_WINDOW_RECT;
}

/// What is known of frames without a radar: their shape, and the chip's 12 bits.
Measurement measurement_of_shape(const Dataset& frames) {
    Measurement measurement;
    measurement.chirp.n_samples = static_cast<std::uint16_t>(frames.n_samples);
    measurement.chirp.n_rx = static_cast<std::uint16_t>(frames.n_rx);
    measurement.chirp.n_chirps = static_cast<std::uint16_t>(frames.n_chirps);
    measurement.chirp.adc_bits = 12;
    measurement.descriptor = {.first_bin = FW_DEFAULT_FIRST_BIN,
                              .n_bins = FW_DEFAULT_N_BINS,
                              .window = window_for(frames.n_samples),
                              .integration = FW_INTEGRATE_MEAN,
                              .path = FW_RANGE_FLOAT};
    return measurement;
}

Model train_on(const VerifyRequest& request, Measurement measurement, VerifyInput& input) {
    const Dataset& frames = input.frames;
    const Descriptor descriptor = asked_descriptor(request.descriptor, measurement.descriptor);
    measurement.descriptor = descriptor.bins;
    FeatureTable rows = describe(frames, descriptor, 1);
    input.model_is = "trained here on these frames";
    if (!has_two_classes(frames)) {
        input.model_is = "trained on arbitrary labels, for its arithmetic alone";
        rows.class_names.clear();
        for (int c = 0; c < arbitrary_classes; ++c)
            rows.class_names.push_back(format("part {}", c));
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows.label[i] = static_cast<std::uint8_t>(i % arbitrary_classes);
    }
    TrainOptions options;
    options.epochs = training_epochs;
    if (!request.hidden.empty()) options.hidden = request.hidden;
    Model model = train(rows, options, {.seed = 1, .purpose = "verify-firmware"});
    model.measurement = measurement;
    model.provenance.emplace_back("descriptor", descriptor.text());
    return model;
}

Dataset load_frames(const VerifyRequest& request) {
    return request.dataset.extension() == ".h5"
               ? read_dataset(request.dataset)
               : import_recording("injection", request.dataset, {}).dataset;
}

void check_fit(const VerifyInput& input, const VerifyRequest& request, const Catalogue& catalogue) {
    try {
        for (const Variant& variant : variants_of(input.model))
            model_blob(input.model, variant.arithmetic);
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", input.model_is, error.what()));
    }
    try {
        expect_same_measurement(
            *input.model.measurement, input.frames,
            request.model.empty() ? std::nullopt : known_radar(input.frames, catalogue));
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", input.frames_are, error.what()));
    }
}

}  // namespace

VerifyInput prepare_verification(const VerifyRequest& request, const Catalogue& catalogue) {
    const bool says_how = !request.descriptor.empty() || !request.hidden.empty();
    if (says_how && !request.model.empty())
        throw InputError(
            format("{}: is trained already; leave out --descriptor and --hidden, which are for a "
                   "model that is trained here",
                   request.model.string()));
    VerifyInput input;
    Measurement measurement;
    Dataset all;
    if (request.dataset.empty()) {
        const Experiment experiment =
            read_experiment(catalogue.experiment_file("paper"), catalogue);
        all = simulate_frames(experiment, catalogue, request.threads);
        measurement = measurement_of(experiment.radar, experiment.descriptor);
        input.frames_are = "simulated (paper, training recordings, world 0)";
    } else {
        all = load_frames(request);
        measurement = measurement_of_shape(all);
        input.frames_are = request.dataset.string();
    }
    if (all.n_frames() < 2)
        throw InputError(
            format("{}: holds {} frames; at least 2 are needed", input.frames_are, all.n_frames()));
    input.frames = thinned(all, static_cast<std::size_t>(request.most_frames));
    if (request.model.empty()) {
        input.model = train_on(request, measurement, input);
    } else {
        input.model = read_model(request.model);
        input.model_is = request.model.string();
    }
    check_fit(input, request, catalogue);
    return input;
}

}  // namespace specula
