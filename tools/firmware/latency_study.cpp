#include "tools/firmware/latency_study.hpp"

#include "classifier/extract_features.hpp"
#include "classifier/integer_model.hpp"
#include "classifier/metrics.hpp"
#include "classifier/model_blob.hpp"
#include "firmware/fw_softmax.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/generate.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/judgement.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

const std::vector<std::vector<int>> sizes{{8},      {8, 8},   {16, 8},  {16, 16},
                                          {24, 16}, {32, 16}, {32, 32}, {64, 32}};

/// What the sizes are judged on.
struct Recorded {
    Dataset one_frame;
    std::vector<Split> splits;             ///< (world)
    std::vector<FeatureTable> rerecorded;  ///< (world)
    Measurement measurement;
};

FeatureTable rows_of_world(const FeatureTable& rows, int world) {
    return select_rows_where(rows, [&](std::size_t i) { return rows.world[i] == world; });
}

const Condition& second_condition(const Experiment& experiment) {
    for (const Condition& condition : experiment.conditions)
        if (condition.name == "rerecorded") return condition;
    if (experiment.conditions.empty())
        throw InputError(experiment.file + ": has no [[condition]] to judge networks on; add one");
    return experiment.conditions.front();
}

Dataset first_frame(const Dataset& dataset) {
    Dataset one = dataset;
    one.truth.resize(1);
    one.adc.resize(dataset.codes_per_frame());
    return one;
}

Recorded record_for(const Experiment& experiment, const LatencyRequest& request,
                    const Catalogue& catalogue) {
    const Bench bench = bench_of(experiment, catalogue.materials);
    const Condition& again = second_condition(experiment);
    Progress progress("Simulating", "sessions",
                      session_count(experiment.training, experiment.population, request.worlds) +
                          session_count(again, experiment.population, request.worlds));
    const Dataset training =
        generate(bench, experiment.training, request.worlds, request.threads, &progress.done());
    const Dataset second =
        generate(bench, again, request.worlds, request.threads, &progress.done());
    const FeatureTable rows = extract_features(training, experiment.descriptor, request.threads);
    const FeatureTable others = extract_features(second, experiment.descriptor, request.threads);
    Recorded recorded{.one_frame = first_frame(training),
                      .splits = {},
                      .rerecorded = {},
                      .measurement = measurement_of(experiment.radar, experiment.descriptor)};
    for (int world = 0; world < request.worlds; ++world) {
        recorded.splits.push_back(
            split_world(rows, world, experiment.validation_share, experiment.seed));
        recorded.rerecorded.push_back(rows_of_world(others, world));
    }
    return recorded;
}

std::vector<std::uint8_t> integer_labels(const Model& model, fw_int_width width,
                                         const FeatureTable& rows) {
    const IntegerModel integers = quantise(model, width);
    const fw_int_mlp mlp = integers.view();
    std::vector<float> scratch(fw_int_mlp_scratch(&mlp) / sizeof(float)), logits(model.n_classes());
    std::vector<std::uint8_t> labels;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        SPECULA_EXPECT(fw_int_mlp_run(&mlp, rows.row(i).data(), scratch.data(),
                                      scratch.size() * sizeof(float), logits.data(),
                                      nullptr) == FW_OK);
        labels.push_back(static_cast<std::uint8_t>(
            fw_argmax(logits.data(), static_cast<std::uint16_t>(logits.size()))));
    }
    return labels;
}

double f1_of(const Model& model, fw_arithmetic arithmetic, const FeatureTable& rows) {
    const std::vector<std::uint8_t> labels =
        arithmetic == FW_ARITHMETIC_FLOAT
            ? predict(fold(model), rows).label
            : integer_labels(model, arithmetic == FW_ARITHMETIC_INT8 ? FW_INT8 : FW_INT16, rows);
    return macro_f1(confusion_of(rows.label, labels, model.n_classes()));
}

std::size_t multiplications(const Model& model) {
    std::size_t n = model.output.n_in * model.output.n_out;
    for (const HiddenLayer& layer : model.hidden) n += layer.n_in * layer.n_out;
    return n;
}

LatencyPoint measure_point(const std::vector<Model>& models, const Variant& variant,
                           const Recorded& recorded, const TargetBuild& build,
                           const Workplace& place) {
    const auto stages = measure_stages(build, place.folder, models.front(), variant);
    const StageCost &network = stages.at("network"), &softmax = stages.at("softmax");
    LatencyPoint point;
    point.arithmetic = variant.name;
    point.n_multiplications = multiplications(models.front());
    point.model_bytes = model_blob(models.front(), variant.arithmetic).size();
    point.instructions = network.instructions + softmax.instructions;
    point.cycles = network.cycles + softmax.cycles;
    for (std::size_t world = 0; world < models.size(); ++world) {
        point.nominal_per_world.push_back(
            f1_of(models[world], variant.arithmetic, recorded.splits[world].validation));
        point.rerecorded_per_world.push_back(
            f1_of(models[world], variant.arithmetic, recorded.rerecorded[world]));
    }
    return point;
}

void compare_with_largest(std::vector<LatencyPoint>& points, std::uint64_t seed) {
    const LatencyPoint largest = points[points.size() - 3];  // the last size in float32
    for (LatencyPoint& point : points) {
        point.nominal =
            bootstrap_mean(point.nominal_per_world, {.seed = seed, .purpose = "latency"});
        point.rerecorded =
            bootstrap_mean(point.rerecorded_per_world, {.seed = seed, .purpose = "latency"});
        point.nominal_loss =
            paired_difference(point.nominal_per_world, largest.nominal_per_world, seed);
        point.rerecorded_loss =
            paired_difference(point.rerecorded_per_world, largest.rerecorded_per_world, seed);
    }
}

}  // namespace

LatencyStudy study_latency(const LatencyRequest& request, const Catalogue& catalogue,
                           const Workplace& place) {
    const Experiment experiment = read_experiment(request.experiment_file, catalogue);
    const Recorded recorded = record_for(experiment, request, catalogue);
    const TargetBuild build = build_for_target(place.home, place.build);
    write_frames(recorded.one_frame, place.folder / "frames.bin");
    LatencyStudy study{.experiment = experiment.name,
                       .worlds = request.worlds,
                       .epochs = experiment.usual.epochs,
                       .points = {}};
    const RunSettings run{.seed = experiment.seed,
                          .worlds = request.worlds,
                          .threads = request.threads,
                          .folder = place.folder};
    Progress progress("Training", "networks", sizes.size() * recorded.splits.size());
    for (const std::vector<int>& hidden : sizes) {
        TrainOptions options = experiment.classifier;
        options.hidden = hidden;
        options.epochs = experiment.usual.epochs;
        std::vector<Model> models = train_worlds(recorded.splits, options, run, progress);
        for (Model& model : models) model.measurement = recorded.measurement;
        for (std::size_t i = 0; i < 3; ++i) {
            study.points.push_back(
                measure_point(models, all_variants()[i], recorded, build, place));
            study.points.back().hidden = hidden;
        }
    }
    compare_with_largest(study.points, experiment.seed);
    return study;
}

}  // namespace specula
