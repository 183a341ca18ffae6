#include "tools/study/calibration.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "classifier/extract_features.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/sha256.hpp"
#include "sim/generate.hpp"
#include "tools/study/judgement.hpp"
#include "tools/study/trial.hpp"

namespace specula {

namespace {

/// Halvings of the admissible span: 20 dB come down to a third of a decibel.
constexpr int most_halvings = 6;
/// Worlds for a ratio that is searched for the record only.
constexpr int record_worlds = 8;

/// Macro-F1 rises with the ratio; returns the trial that came nearest to the target.
CalibrationTrial bisect(const CalibrationPlan& plan, std::array<double, 2> span,
                        const NominalSource& nominal, const Extent& extent,
                        std::vector<CalibrationTrial>& trials) {
    CalibrationTrial best{.snr_db = span[1], .macro_f1 = 2.0};
    for (int i = 0; i < most_halvings; ++i) {
        const double snr_db = 0.5 * (span[0] + span[1]);
        const CalibrationTrial trial{snr_db, nominal.macro_f1(snr_db, extent)};
        trials.push_back(trial);
        const double miss = trial.macro_f1 - plan.target_macro_f1;
        if (std::abs(miss) < std::abs(best.macro_f1 - plan.target_macro_f1)) best = trial;
        if (std::abs(miss) <= plan.tolerance) break;
        span[miss > 0.0 ? 1 : 0] = snr_db;
    }
    return best;
}

}  // namespace

NominalSource::NominalSource(const Experiment& experiment, const Library& materials,
                             const RunSettings& run)
    : experiment_(experiment), materials_(materials), run_(run) {
    const Condition& training = experiment.training;
    const bool nominal = training.heights_m.size() == 1 && training.tilts_rad.size() == 1 &&
                         training.heights_m[0] == experiment.nominal_height_m &&
                         training.tilts_rad[0] == 0.0;
    if (!nominal)
        throw InputError(experiment.file +
                         ": training: is not at the nominal height without tilt, and calibrations "
                         "may see nothing else; remove its heights and tilts");
}

double NominalSource::macro_f1(double snr_db, const Extent& extent) const {
    Assumption ratio;
    ratio.snr_db = snr_db;
    const Experiment tried = under(ratio, experiment_);
    Bench bench = bench_of(tried, materials_);
    bench.seed = run_.seed;
    FeatureTable rows;
    {
        Progress progress("Calibrating", "sessions",
                          session_count(tried.training, tried.population, extent.worlds));
        rows = extract_features(
            generate(bench, tried.training, extent.worlds, run_.threads, &progress.done()),
            tried.descriptor, run_.threads);
    }
    WorldRows training, validation;
    for (int world = 0; world < extent.worlds; ++world) {
        Split split = split_world(rows, world, tried.validation_share, run_.seed);
        training.push_back(std::move(split.training));
        validation.push_back(std::move(split.validation));
    }
    TrialTraining how{.options = tried.classifier, .seed = run_.seed, .threads = run_.threads};
    how.options.epochs = extent.epochs;
    const auto outcomes = judge_each(train_each(training, how), validation, run_.threads);
    std::vector<int> unmerged;
    for (std::size_t i = 0; i < rows.class_names.size(); ++i)
        unmerged.push_back(static_cast<int>(i));
    double sum = 0.0;
    for (const double f1 : scores_of(outcomes, unmerged).all) sum += f1;
    return sum / static_cast<double>(extent.worlds);
}

CalibrationOutcome calibrate(const CalibrationPlan& plan, const NominalSource& nominal,
                             const Extent& extent) {
    CalibrationOutcome outcome;
    outcome.asked = true;
    outcome.target_macro_f1 = plan.target_macro_f1;
    outcome.tolerance = plan.tolerance;
    outcome.admissible_snr_db = plan.admissible_snr_db;
    const auto meets = [&](const CalibrationTrial& trial) {
        return std::abs(trial.macro_f1 - plan.target_macro_f1) <= plan.tolerance;
    };
    CalibrationTrial trial{0.0, nominal.macro_f1(0.0, extent)};
    outcome.trials.push_back(trial);
    const bool too_good = trial.macro_f1 > plan.target_macro_f1;
    const std::array<double, 2> inside = too_good ? std::array{plan.admissible_snr_db[0], 0.0}
                                                  : std::array{0.0, plan.admissible_snr_db[1]};
    if (!meets(trial) && inside[0] < inside[1])
        trial = bisect(plan, inside, nominal, extent, outcome.trials);
    outcome.reached = meets(trial);
    if (outcome.reached) {
        outcome.snr_db = trial.snr_db;
        outcome.matching = trial;
        return outcome;
    }
    if (extent.variant_worlds == 0) return outcome;  // nobody would use what is found
    Extent few = extent;
    few.worlds = std::min(extent.worlds, record_worlds);
    const std::array<double, 2> beyond = too_good ? std::array{plan.search_snr_db[0], inside[0]}
                                                  : std::array{inside[1], plan.search_snr_db[1]};
    if (beyond[0] < beyond[1]) {
        const CalibrationTrial found = bisect(plan, beyond, nominal, few, outcome.trials);
        if (meets(found)) outcome.matching = found;
    }
    return outcome;
}

FrozenCalibration freeze_calibration(const CalibrationOutcome& outcome,
                                     const std::filesystem::path& file) {
    using Json = nlohmann::ordered_json;
    Json json{{"format", "specula-calibration"},
              {"format_version", 1},
              {"parameter", "signal-to-noise ratio against one frame of the radar file, dB"},
              {"snr_db", outcome.snr_db}};
    if (outcome.asked) {
        json["target_macro_f1"] = outcome.target_macro_f1;
        json["tolerance"] = outcome.tolerance;
        json["admissible_snr_db"] = outcome.admissible_snr_db;
        json["reached_by_an_admissible_value"] = outcome.reached;
        for (const CalibrationTrial& trial : outcome.trials)
            json["trials"].push_back({{"snr_db", trial.snr_db}, {"macro_f1", trial.macro_f1}});
        json["matching"] = outcome.matching ? Json{{"snr_db", outcome.matching->snr_db},
                                                   {"macro_f1", outcome.matching->macro_f1}}
                                            : Json(nullptr);
    }
    const std::string text = json.dump(2) + "\n";
    write_file_atomically(file, text);
    CalibrationOutcome frozen = outcome;
    frozen.sha256 = sha256_of(text);
    return FrozenCalibration(std::move(frozen));
}

}  // namespace specula
