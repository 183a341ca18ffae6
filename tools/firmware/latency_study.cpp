#include "tools/firmware/latency_study.hpp"

#include "classifier/descriptor.hpp"
#include "classifier/integer_model.hpp"
#include "classifier/metrics.hpp"
#include "classifier/model_blob.hpp"
#include "firmware/fw_softmax.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/generate.hpp"
#include "tools/firmware/asked_descriptor.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/judgement.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

const std::vector<std::vector<int>> sizes{{8},      {8, 8},   {16, 8},  {16, 16},
                                          {24, 16}, {32, 16}, {32, 32}, {64, 32}};

/// Frames of one kind to judge networks on.
struct Judged {
    std::string condition;
    std::vector<FeatureTable> rows;  ///< (world)
};

/// What the sizes are judged on.
struct Recorded {
    Dataset one_frame;
    std::vector<Split> splits;   ///< (world)
    std::vector<Judged> judged;  ///< nominal, then every condition of the experiment
    std::size_t rerecorded = 0;  ///< which of them
    Measurement measurement;
    Descriptor descriptor;
};

FeatureTable rows_of_world(const FeatureTable& rows, int world) {
    return select_rows_where(rows, [&](std::size_t i) { return rows.world[i] == world; });
}

/// Place of the second condition to judge on: "rerecorded", or the first there is.
std::size_t second_condition(const Experiment& experiment) {
    for (std::size_t i = 0; i < experiment.conditions.size(); ++i)
        if (experiment.conditions[i].name == "rerecorded") return i;
    if (experiment.conditions.empty())
        throw InputError(experiment.file + ": has no [[condition]] to judge networks on; add one");
    return 0;
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
    const Descriptor descriptor = asked_descriptor(request.descriptor, experiment.descriptor);
    Recorded recorded{.one_frame = {},
                      .splits = {},
                      .judged = {{"nominal", {}}},
                      .rerecorded = 1 + second_condition(experiment),
                      .measurement = measurement_of(experiment.radar, descriptor.bins),
                      .descriptor = descriptor};
    std::size_t n_sessions =
        session_count(experiment.training, experiment.population, request.worlds);
    for (const Condition& condition : experiment.conditions)
        n_sessions += session_count(condition, experiment.population, request.worlds);
    Progress progress("Simulating", "sessions", n_sessions);
    const auto rows_under = [&](const Condition& condition, Dataset& frames) {
        frames = generate(bench, condition, request.worlds, request.threads, &progress.done());
        return describe(frames, descriptor, request.threads);
    };
    Dataset frames;
    const FeatureTable training = rows_under(experiment.training, frames);
    recorded.one_frame = first_frame(frames);
    for (int world = 0; world < request.worlds; ++world) {
        recorded.splits.push_back(
            split_world(training, world, experiment.validation_share, experiment.seed));
        recorded.judged.front().rows.push_back(recorded.splits.back().validation);
    }
    for (const Condition& condition : experiment.conditions) {
        const FeatureTable rows = rows_under(condition, frames);
        recorded.judged.push_back({condition.name, {}});
        for (int world = 0; world < request.worlds; ++world)
            recorded.judged.back().rows.push_back(rows_of_world(rows, world));
    }
    return recorded;
}

/// What a network says about rows.
struct Answers {
    std::vector<std::uint8_t> label;
    std::size_t n_clipped = 0;  ///< rows with an input beyond the integers' reach
};

Answers integer_answers(const Model& model, fw_int_width width, const FeatureTable& rows) {
    const IntegerModel integers = quantise(model, width);
    const fw_int_mlp mlp = integers.view();
    std::vector<float> scratch(fw_int_mlp_scratch(&mlp) / sizeof(float)), logits(model.n_classes());
    Answers answers;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float* const row = rows.row(i).data();
        SPECULA_EXPECT(fw_int_mlp_run(&mlp, row, scratch.data(), scratch.size() * sizeof(float),
                                      logits.data(), nullptr) == FW_OK);
        answers.label.push_back(static_cast<std::uint8_t>(
            fw_argmax(logits.data(), static_cast<std::uint16_t>(logits.size()))));
        answers.n_clipped += fw_int_clipped(&mlp, row) > 0;
    }
    return answers;
}

Answers answers_of(const Model& model, fw_arithmetic arithmetic, const FeatureTable& rows) {
    if (arithmetic == FW_ARITHMETIC_FLOAT) return {predict(fold(model), rows).label, 0};
    return integer_answers(model, arithmetic == FW_ARITHMETIC_INT8 ? FW_INT8 : FW_INT16, rows);
}

/// One kind of frames in one arithmetic, over all worlds.
struct Outcome {
    Agreement agreement;
    std::vector<double> f1_per_world;
};

Outcome judge(const std::vector<Model>& models, fw_arithmetic arithmetic, const Judged& judged) {
    Outcome outcome;
    outcome.agreement.condition = judged.condition;
    double frames = 0.0, same = 0.0, clipped = 0.0;
    for (std::size_t world = 0; world < models.size(); ++world) {
        const FeatureTable& rows = judged.rows[world];
        const Answers here = answers_of(models[world], arithmetic, rows);
        const Answers real = answers_of(models[world], FW_ARITHMETIC_FLOAT, rows);
        const auto f1 = [&](const Answers& answers) {
            return macro_f1(
                confusion_of(rows.label, answers.label, models[world].class_names.size()));
        };
        outcome.f1_per_world.push_back(f1(here));
        outcome.agreement.f1_change += (f1(here) - f1(real)) / static_cast<double>(models.size());
        for (std::size_t i = 0; i < rows.size(); ++i) same += here.label[i] == real.label[i];
        clipped += static_cast<double>(here.n_clipped);
        frames += static_cast<double>(rows.size());
    }
    outcome.agreement.same_label = same / frames;
    outcome.agreement.clipped = clipped / frames;
    return outcome;
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
    point.features = stages.at("describe");
    for (std::size_t i = 0; i < recorded.judged.size(); ++i) {
        const Outcome outcome = judge(models, variant.arithmetic, recorded.judged[i]);
        point.agreement.push_back(outcome.agreement);
        if (i == 0) point.nominal_per_world = outcome.f1_per_world;
        if (i == recorded.rerecorded) point.rerecorded_per_world = outcome.f1_per_world;
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
                       .descriptor = recorded.descriptor.text(),
                       .n_features = recorded.descriptor.n_features(),
                       .n_classes = recorded.one_frame.class_names.size(),
                       .n_rows = recorded.one_frame.codes_per_frame() /
                                 static_cast<std::size_t>(recorded.one_frame.n_samples),
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
        for (Model& model : models) {
            model.measurement = recorded.measurement;
            model.provenance.emplace_back("descriptor", study.descriptor);
        }
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
