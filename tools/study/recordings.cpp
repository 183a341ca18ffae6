#include "tools/study/recordings.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/descriptor.hpp"
#include "classifier/extract_features.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/generate.hpp"
#include "tools/study/calibration.hpp"

namespace specula {

namespace {

/// What an ideal reference reflector would allow: features as if the gain were nominal.
void divide_by_gain(const Dataset& dataset, FeatureTable& table) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto factor = static_cast<float>(std::pow(10.0, -dataset.truth[i].gain_db / 20.0));
        for (std::size_t k = 0; k < table.n_features; ++k)
            table.features[i * table.n_features + k] *= factor;
    }
}

std::map<std::string, FeatureTable> describe_rungs(const Dataset& dataset,
                                                   const Experiment& experiment,
                                                   const RunSettings& run) {
    std::map<std::string, FeatureTable> described;
    const auto& sets = experiment.protocol.training_sets;
    const bool is_set = std::ranges::any_of(sets, [&](const TrainingSet& set) {
        return set.condition.name == dataset.origin.condition;
    });
    for (const RungPlan& rung : experiment.protocol.rungs) {
        if (std::ranges::find(run.kinds, rung.kind()) == run.kinds.end()) continue;
        if (described.count(rung.kind()) != 0) continue;
        if (is_set && rung.training != dataset.origin.condition) continue;
        FeatureTable table = describe(dataset, parse_descriptor(rung.descriptor), run.threads);
        if (rung.known_gain) divide_by_gain(dataset, table);
        described.emplace(rung.kind(), std::move(table));
    }
    return described;
}

Dataset simulate_condition(const Source& source, const RunSettings& run, const Condition& condition,
                           Progress& progress, std::size_t* weak) {
    if (run.before_recording) run.before_recording(condition);
    Bench bench = bench_of(source.experiment, source.materials);
    bench.seed = run.seed;
    return generate(bench, condition, run.worlds, run.threads, &progress.done(), weak);
}

Recording record(const Source& source, const RunSettings& run, const Condition& condition,
                 Progress& progress) {
    Recording recording;
    recording.condition = condition;
    recording.file = run.folder / "datasets" / (condition.name + ".h5");
    {
        Dataset simulated =
            simulate_condition(source, run, condition, progress, &recording.weak_echoes);
        simulated.origin.experiment = source.experiment.source;
        simulated.origin.version = program_version;
        write_dataset(recording.file, simulated);
    }
    const Dataset dataset = read_dataset(recording.file);
    recording.fingerprint = fingerprint(dataset);
    recording.features = extract_features(dataset, source.experiment.descriptor, run.threads);
    recording.described = describe_rungs(dataset, source.experiment, run);
    recording.truth = dataset.truth;
    return recording;
}

}  // namespace

Recording record_nominal(const Source& source, const RunSettings& run, Progress& progress) {
    return record(source, run, source.experiment.training, progress);
}

Recording record_shifted(const FrozenCalibration&, const Source& source, const RunSettings& run,
                         const Condition& condition, Progress& progress) {
    return record(source, run, condition, progress);
}

PassingRecording observe(const FrozenCalibration&, const Source& source, const RunSettings& run,
                         const Condition& condition, Progress& progress) {
    const Dataset dataset = simulate_condition(source, run, condition, progress, nullptr);
    return {.features = extract_features(dataset, source.experiment.descriptor, run.threads),
            .described = describe_rungs(dataset, source.experiment, run),
            .fingerprint = fingerprint(dataset)};
}

FeatureTable rows_of_geometry(const FeatureTable& rows, const Condition& condition, int geometry) {
    return select_rows_where(rows, [&](std::size_t i) {
        const int session = rows.session[i] & (Condition::most_sessions - 1);
        return session / condition.sessions == geometry;
    });
}

}  // namespace specula
