#include "tools/study/study.hpp"

#include <algorithm>

#include "classifier/export_c.hpp"
#include "classifier/measurement.hpp"
#include "classifier/metrics.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/sha256.hpp"
#include "sim/generate.hpp"
#include "tools/report/study_page.hpp"
#include "tools/study/attribution.hpp"
#include "tools/study/results_json.hpp"
#include "tools/study/stage_clock.hpp"
#include "tools/study/study_facts.hpp"
#include "tools/study/study_stages.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

void make_folders(const fs::path& out) {
    for (const char* name : {"datasets", "models", "firmware", "figures"})
        make_output_folder(out / name);
}

/// The experiment's name as part of a C name: export_c takes up to 32 of a-z, 0-9 and _.
std::string c_name(const std::string& experiment) {
    std::string name;
    for (const char c : experiment) {
        const bool upper = c >= 'A' && c <= 'Z';
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        name += upper ? static_cast<char>(c - 'A' + 'a') : plain ? c : '_';
    }
    if (name.empty() || name[0] < 'a' || name[0] > 'z') name = "study_" + name;
    return name.substr(0, 32);
}

void write_models(std::vector<Model>& models, const Experiment& experiment, const fs::path& out) {
    for (Model& model : models)
        model.measurement = measurement_of(experiment.radar, experiment.descriptor);
    for (std::size_t world = 0; world < models.size(); ++world)
        write_model(models[world], out / "models" / format("world_{:03}.json", world));
    const ExportedModel exported = export_c(models.front(), c_name(experiment.name));
    write_file_atomically(out / "firmware" / exported.header_name, exported.header);
    write_file_atomically(out / "firmware" / exported.source_name, exported.source);
}

const Extent& extent_of(const StudyRequest& request, const Experiment& experiment) {
    return request.quick ? experiment.quick : request.full ? experiment.full : experiment.usual;
}

/// Nominal recordings alone decide; the file appears before any other geometry is simulated.
FrozenCalibration calibrated(const std::optional<NominalSource>& nominal,
                             const Experiment& experiment, const RunSettings& run,
                             const Extent& extent) {
    CalibrationOutcome outcome;
    if (nominal) outcome = calibrate(*experiment.protocol.calibration, *nominal, extent);
    return freeze_calibration(outcome, run.folder / "calibration.json");
}

std::vector<Recording> record_all(const FrozenCalibration& frozen, const Source& source,
                                  const RunSettings& run) {
    const Experiment& experiment = source.experiment;
    std::size_t sessions = session_count(experiment.training, experiment.population, run.worlds);
    for (const Condition& condition : experiment.conditions)
        sessions += session_count(condition, experiment.population, run.worlds);
    Progress progress("Recording", "sessions", sessions);
    std::vector<Recording> recordings;
    recordings.push_back(record_nominal(source, run, progress));
    for (const Condition& condition : experiment.conditions)
        recordings.push_back(record_shifted(frozen, source, run, condition, progress));
    return recordings;
}

/// What recordings are described as for the ladder; rungs in motion have recordings of their own.
std::vector<std::string> still_kinds(const Experiment& experiment, const Extent& extent) {
    std::vector<std::string> kinds;
    for (const RungPlan& rung : experiment.protocol.rungs)
        if (extent.ladder && !rung.motion) kinds.push_back(rung.kind());
    return kinds;
}

void describe_study(const StudyRequest& request, const StudyContext& context,
                    StudySummary& summary) {
    const Experiment& experiment = context.experiment;
    summary.title = experiment.title;
    summary.paper_reference = experiment.paper_reference;
    summary.class_names = experiment.population.class_names();
    summary.merged_classes = experiment.merged_classes;
    summary.merged_label = merged_label(experiment);
    summary.radar = facts_of(experiment);
    summary.warnings = warnings_of(experiment, context.materials);
    summary.seed = context.run.seed;
    summary.repeats = context.extent.seeds;
    summary.version = program_version;
    summary.command = request.command;
    summary.experiment = experiment.name + ".toml";
}

}  // namespace

StudySummary run_study(const StudyRequest& request, const Catalogue& catalogue) {
    const Experiment experiment = read_experiment(request.experiment_file, catalogue);
    const Extent& extent = extent_of(request, experiment);
    const RunSettings run{.seed = request.seed.value_or(experiment.seed),
                          .worlds = extent.worlds,
                          .threads = request.threads,
                          .folder = request.out,
                          .kinds = still_kinds(experiment, extent),
                          .before_recording = request.before_recording};
    std::optional<NominalSource> nominal;  // refuses what is no nominal geometry
    if (experiment.protocol.calibration) nominal.emplace(experiment, catalogue.materials, run);
    make_folders(request.out);
    StageClock clock;
    const FrozenCalibration frozen = calibrated(nominal, experiment, run, extent);
    clock.ended("calibration");
    Assumption ratio;
    ratio.snr_db = frozen.outcome().snr_db;
    const Experiment used = under(ratio, experiment);
    const StudyContext context{.experiment = used,
                               .materials = catalogue.materials,
                               .frozen = frozen,
                               .run = run,
                               .extent = extent,
                               .merged = merged_map(used)};
    const std::vector<Recording> recordings = record_all(frozen, context.source(), run);
    clock.ended("recording");

    StudySummary summary;
    describe_study(request, context, summary);
    summary.fingerprints.emplace_back(summary.experiment, "sha256 " + sha256_of(used.source));
    warn_of_weak_echoes(recordings, used, run, summary.warnings);
    for (const Recording& recording : recordings)
        summary.fingerprints.emplace_back(recording.file.filename().string(),
                                          "fingerprint " + recording.fingerprint);
    summary.results.calibration = frozen.outcome();
    summary.fingerprints.emplace_back("calibration.json", "sha256 " + frozen.outcome().sha256);
    Baseline baseline = train_baseline(context, recordings.front());
    write_models(baseline.models, used, request.out);
    clock.ended("training");
    judge_conditions(context, recordings, baseline, summary);
    clock.ended("judging");
    extend_study({context, recordings, baseline}, clock, summary);

    write_file_atomically(request.out / "results.json", results_json(summary));
    if (request.report) write_study_report(request.out, summary);
    clock.ended("report");
    write_file_atomically(request.out / "stages.csv", clock.csv());
    return summary;
}

}  // namespace specula
