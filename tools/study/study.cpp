#include "tools/study/study.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/export_c.hpp"
#include "classifier/measurement.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/generate.hpp"
#include "sim/limits.hpp"
#include "tools/report/study_page.hpp"
#include "tools/study/judgement.hpp"
#include "tools/study/results_json.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

void make_folders(const fs::path& out) {
    for (const char* name : {"datasets", "models", "firmware", "figures"}) {
        std::error_code error;
        fs::create_directories(out / name, error);
        if (error)
            throw SystemError(
                format("{}: cannot create: {}", (out / name).string(), error.message()));
    }
}

std::vector<Recording> record_all(const Experiment& experiment, const Library& materials,
                                  const RunSettings& run) {
    std::vector<Condition> all{experiment.training};
    all.insert(all.end(), experiment.conditions.begin(), experiment.conditions.end());
    std::size_t sessions = 0;
    for (const Condition& condition : all)
        sessions += session_count(condition, experiment.population, run.worlds);
    Progress progress("Recording", "sessions", sessions);
    std::vector<Recording> recordings;
    for (const Condition& condition : all)
        recordings.push_back(record(experiment, materials, run, condition, progress));
    return recordings;
}

/// Mean and standard deviation of every feature, class by class.
std::vector<ClassProfile> profiles_of(const FeatureTable& rows) {
    std::vector<ClassProfile> profiles(rows.class_names.size());
    std::vector<double> count(rows.class_names.size(), 0.0);
    for (ClassProfile& profile : profiles) {
        profile.mean.assign(rows.n_features, 0.0);
        profile.sd.assign(rows.n_features, 0.0);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ClassProfile& profile = profiles[rows.label[i]];
        count[rows.label[i]] += 1.0;
        for (std::size_t k = 0; k < rows.n_features; ++k) {
            const double value = rows.row(i)[k];
            profile.mean[k] += value;
            profile.sd[k] += value * value;
        }
    }
    for (std::size_t label = 0; label < profiles.size(); ++label) {
        const double n = std::max(1.0, count[label]);
        for (std::size_t k = 0; k < rows.n_features; ++k) {
            double& mean = profiles[label].mean[k];
            double& sd = profiles[label].sd[k];
            mean /= n;
            sd = std::sqrt(std::max(0.0, sd / n - mean * mean));
        }
    }
    return profiles;
}

/// Class -> merged class: the named ones together, the others each alone.
std::vector<int> merged_map(const Experiment& experiment) {
    const auto& merged = experiment.merged_classes;
    std::vector<int> map;
    int next = merged.empty() ? 0 : 1;
    for (std::size_t label = 0; label < experiment.population.classes.size(); ++label) {
        const bool together = std::find(merged.begin(), merged.end(), label) != merged.end();
        map.push_back(together ? 0 : next++);
    }
    return map;
}

std::string merged_label(const Experiment& experiment) {
    std::string label;
    for (const std::size_t i : experiment.merged_classes)
        label += (label.empty() ? "" : " and ") + experiment.population.classes[i].name;
    return label.empty() ? "none merged" : label + " merged";
}

RadarFacts facts_of(const Experiment& experiment) {
    const Chirp& chirp = experiment.radar.chirp;
    return {.name = experiment.radar.title,
            .start_frequency_hz = chirp.frequency_hz(0),
            .slope_hz_s = chirp.slope_hz_s,
            .sampled_bandwidth_hz = chirp.bandwidth_hz(),
            .range_bin_m = chirp.bin_m(),
            .nominal_height_m = experiment.nominal_height_m,
            .nominal_height_bin = chirp.bin_of(experiment.nominal_height_m),
            .first_descriptor_bin = experiment.descriptor.first_bin,
            .feature_quantity = "amplitude (LSB)"};
}

/// Of all classes, each once: materials outside their band, and where optics is known to fail.
std::vector<std::string> warnings_of(const Experiment& experiment, const Library& materials) {
    const FrequencyBand band = experiment.radar.chirp.band();
    std::vector<std::string> warnings;
    const auto add = [&](const std::string& text) {
        if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
            warnings.push_back(text);
    };
    for (const SampleLaw& law : experiment.population.classes) {
        for (const BandWarning& warning : band_warnings(law.nominal, materials, band))
            add(warning.text());
        Scene scene;
        scene.radar = experiment.radar;
        scene.sample = law.nominal;
        scene.sample.roughness_m = law.roughness_m.median();
        scene.sample.correlation_m = law.correlation_m.median();
        for (const std::string& warning : roughness_warnings(scene.sample, band))
            add(law.name + ": " + warning);
        for (const std::string& limit : optics_limits(scene, materials))
            add(law.name + ": " + limit);
    }
    return warnings;
}

void warn_of_weak_echoes(const std::vector<Recording>& recordings, const Experiment& experiment,
                         const RunSettings& run, std::vector<std::string>& warnings) {
    for (const Recording& recording : recordings) {
        if (recording.weak_echoes == 0) continue;
        warnings.push_back(format(
            "{}: {} of {} sessions have an echo 15 dB or more below that of an endless sheet; "
            "edges count there, and full-wave solutions differ by up to 1.5 dB",
            recording.condition.title, recording.weak_echoes,
            session_count(recording.condition, experiment.population, run.worlds)));
    }
}

std::vector<Split> split_worlds(const Experiment& experiment, const FeatureTable& recorded,
                                const RunSettings& run) {
    std::vector<Split> splits;
    for (int world = 0; world < run.worlds; ++world)
        splits.push_back(split_world(recorded, world, experiment.validation_share, run.seed));
    return splits;
}

/// The rows of all worlds that were held back.
FeatureTable joined_validation(const std::vector<Split>& splits) {
    FeatureTable rows = splits.front().validation;
    for (std::size_t world = 1; world < splits.size(); ++world) {
        const FeatureTable& more = splits[world].validation;
        rows.features.insert(rows.features.end(), more.features.begin(), more.features.end());
        rows.label.insert(rows.label.end(), more.label.begin(), more.label.end());
        rows.world.insert(rows.world.end(), more.world.begin(), more.world.end());
        rows.session.insert(rows.session.end(), more.session.begin(), more.session.end());
    }
    return rows;
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

}  // namespace

StudySummary run_study(const StudyRequest& request, const Catalogue& catalogue) {
    const Experiment experiment = read_experiment(request.experiment_file, catalogue);
    const Extent extent = request.quick ? experiment.quick : experiment.full;
    const RunSettings run{.seed = request.seed.value_or(experiment.seed),
                          .worlds = extent.worlds,
                          .threads = request.threads,
                          .folder = request.out};
    make_folders(request.out);
    const std::vector<Recording> recordings = record_all(experiment, catalogue.materials, run);

    TrainOptions options = experiment.classifier;
    options.epochs = extent.epochs;
    const auto splits = split_worlds(experiment, recordings.front().features, run);
    std::vector<Model> models;
    {
        Progress progress("Training", "worlds", splits.size());
        models = train_worlds(splits, options, run, progress);
    }
    write_models(models, experiment, request.out);

    StudySummary summary;
    summary.title = experiment.title;
    summary.paper_reference = experiment.paper_reference;
    summary.class_names = experiment.population.class_names();
    summary.merged_classes = experiment.merged_classes;
    summary.merged_label = merged_label(experiment);
    summary.radar = facts_of(experiment);
    summary.warnings = warnings_of(experiment, catalogue.materials);
    warn_of_weak_echoes(recordings, experiment, run, summary.warnings);
    summary.seed = run.seed;
    summary.version = program_version;
    summary.command = request.command;
    summary.experiment = experiment.name + ".toml";
    const Scoring scoring{merged_map(experiment), {.seed = run.seed, .purpose = "bootstrap"}};
    const auto add = [&](const std::string& name, const std::string& title,
                         const FeatureTable& rows, const std::vector<double>& heights_m) {
        StudyCondition condition;
        condition.result = evaluate(name, title, judge(models, rows, run), scoring);
        condition.heights_m = heights_m;
        condition.features = profiles_of(rows);
        const auto paper = experiment.paper_macro_f1.find(name);
        if (paper != experiment.paper_macro_f1.end()) condition.paper_macro_f1 = paper->second;
        summary.conditions.push_back(condition);
    };
    add(std::string(nominal_condition), experiment.validation_title, joined_validation(splits),
        {experiment.nominal_height_m});
    for (std::size_t i = 1; i < recordings.size(); ++i)
        add(recordings[i].condition.name, recordings[i].condition.title, recordings[i].features,
            recordings[i].condition.heights_m);
    for (const Recording& recording : recordings)
        summary.fingerprints.emplace_back(recording.file.filename().string(),
                                          recording.fingerprint);

    write_file_atomically(request.out / "results.json", results_json(summary));
    write_study_report(request.out, summary);
    return summary;
}

}  // namespace specula
