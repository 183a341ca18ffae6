#include <algorithm>
#include <cstdio>

#include "classifier/assessment.hpp"
#include "classifier/cross_validation.hpp"
#include "classifier/measurement.hpp"
#include "classifier/model_file.hpp"
#include "classifier/nearest_neighbours.hpp"
#include "classifier/predict.hpp"
#include "classifier/session_split.hpp"
#include "classifier/train.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/evaluation_text.hpp"
#include "tools/specula/learning.hpp"
#include "tools/specula/output_place.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

Model trained_with_progress(const FeatureTable& rows, const Learning& learning) {
    const TrainOptions options = training_options(learning);
    Progress progress("Training", "epochs", static_cast<std::size_t>(options.epochs));
    return train(rows, options, {.seed = learning.seed, .purpose = "training"},
                 {.epochs_done = &progress.done()});
}

void print_own_score(const FeatureTable& rows, const Model& model,
                     const TrainArguments& arguments) {
    const Predictions own = predict(fold(model), rows);
    std::printf(
        "of the frames it learnt from, %.1f %% are recognised; that says nothing about others:\n"
        "see specula evaluate %s --leave-out session, or train with --holdout session\n",
        100.0 * accuracy(rows.label, own.label), arguments.data.c_str());
}

void print_held_out(const SessionSplit& split, const Model& model) {
    const Predictions answers = predict(fold(model), split.held_out);
    const Assessment assessment =
        assess(split.held_out, answers,
               {.merged_class = {}, .resampling = {.key = {.seed = 1, .purpose = "bootstrap"}}});
    std::printf("\nOn the sessions held out:\n");
    print_assessment(assessment, {.class_names = model.class_names});
    std::printf("\n");
}

bool made_such_frames(const Radar& radar, const Dataset& dataset) {
    return radar.chirp.n_samples == dataset.n_samples &&
           static_cast<int>(radar.rx.size()) == dataset.n_rx &&
           radar.chirps_per_frame == dataset.n_chirps;
}

/// The chirp that features rest on: of the radar named, else of the dataset's where it is known.
std::optional<Measurement> measurement_for(const TrainArguments& arguments, const Dataset& dataset,
                                           const Descriptor& descriptor,
                                           const Catalogue& catalogue) {
    const bool is_named = !arguments.radar.empty();
    const auto known = catalogue.radar_names();
    const std::string& name = is_named ? arguments.radar : dataset.origin.radar;
    if (!is_named && std::ranges::find(known, name) == known.end()) return std::nullopt;
    const Radar radar = catalogue.radar_called(name);
    const bool fits = dataset.sample_axis == SampleAxis::beat && made_such_frames(radar, dataset);
    if (is_named && !fits)
        throw InputError(
            format("--radar {}: sends {} chirps of {} samples to {} receivers a frame, and the "
                   "frames hold {} of {} from {}; name the radar that made them",
                   name, radar.chirps_per_frame, radar.chirp.n_samples, radar.rx.size(),
                   dataset.n_chirps, dataset.n_samples, dataset.n_rx));
    if (!fits) return std::nullopt;
    return measurement_of(radar, descriptor.bins);
}

}  // namespace

void train_command(const TrainArguments& arguments, const Catalogue& catalogue) {
    expect_heeded(arguments.given, arguments.learning, arguments.holdout);
    prepare_output(arguments.out, {arguments.data, arguments.radar});
    const Dataset dataset = dataset_from(arguments.data);
    try {
        const Learning& learning = arguments.learning;
        const Descriptor descriptor = chosen_descriptor(learning, dataset);
        const auto measurement = measurement_for(arguments, dataset, descriptor, catalogue);
        SessionSplit split{.training = described(dataset, descriptor, learning.threads),
                           .held_out = {}};
        const bool holds_out = !arguments.holdout.empty();
        if (holds_out) {
            check_options(training_options(learning), descriptor.n_features());
            if (learning.options.held_out == 0.0)
                throw InputError("--held-out = 0: holds nothing out; use about 0.2");
            split = hold_out_sessions(split.training, learning.options.held_out,
                                      {.seed = learning.seed, .purpose = "judged sessions"});
        }
        Model model = trained_with_progress(split.training, learning);
        if (holds_out)
            model.provenance.emplace_back("rows held out to judge",
                                          format("{}", split.held_out.size()));
        model.provenance.emplace_back("descriptor", descriptor.text());
        model.provenance.emplace_back("dataset", fingerprint(dataset));
        model.measurement = measurement;
        model.feature_names = feature_names_of(dataset, descriptor);
        model.prototypes = kept(fit_prototypes(
            split.training, {}, {.seed = learning.seed, .purpose = "prototypes"}));
        write_model(model, arguments.out);
        std::printf("%zu frames of %zu classes, descriptor %s\n", split.training.size(),
                    dataset.class_names.size(), descriptor.text().c_str());
        if (holds_out)
            print_held_out(split, model);
        else
            print_own_score(split.training, model, arguments);
        std::printf("Wrote %s\n", arguments.out.c_str());
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", arguments.data.string(), error.what()));
    }
}

}  // namespace specula
