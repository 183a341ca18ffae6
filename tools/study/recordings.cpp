#include "tools/study/recordings.hpp"

#include "classifier/extract_features.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/generate.hpp"

namespace specula {

Recording record(const Experiment& experiment, const Library& materials, const RunSettings& run,
                 const Condition& condition, Progress& progress) {
    Bench bench = bench_of(experiment, materials);
    bench.seed = run.seed;
    Recording recording;
    recording.condition = condition;
    recording.file = run.folder / "datasets" / (condition.name + ".h5");
    {
        Dataset simulated = generate(bench, condition, run.worlds, run.threads, &progress.done(),
                                     &recording.weak_echoes);
        simulated.origin.experiment = experiment.source;
        simulated.origin.version = program_version;
        write_dataset(recording.file, simulated);
    }
    const Dataset dataset = read_dataset(recording.file);
    recording.fingerprint = fingerprint(dataset);
    recording.features = extract_features(dataset, experiment.descriptor, run.threads);
    return recording;
}

}  // namespace specula
