#include "tools/study/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"
#include "sim/dataset/sha256.hpp"
#include "sim/generate.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

namespace {

constexpr double prior_tolerance = 0.02;

std::vector<Condition> judged_conditions(const StudyContext& context) {
    std::vector<Condition> judged;
    for (const std::string& name : context.experiment.protocol.variant_conditions)
        for (const Condition& condition : context.experiment.conditions)
            if (condition.name == name) judged.push_back(condition);
    return judged;
}

std::size_t sessions_of(const Experiment& experiment, const std::vector<Condition>& judged,
                        int worlds) {
    std::size_t n = session_count(experiment.training, experiment.population, worlds);
    for (const Condition& condition : judged)
        n += session_count(condition, experiment.population, worlds);
    return n;
}

/// Everything of one assumption: recorded, trained, judged; `first_world` names the world drawn.
SensitivityRow row_under(const Assumption& assumption, const StudyContext& context, int worlds,
                         Progress& progress) {
    const Experiment other = under(assumption, context.experiment);
    const Source source{other, context.materials};
    const RunSettings run = context.run_with(worlds);
    SensitivityRow row{.name = assumption.name, .title = assumption.title};
    const PassingRecording training =
        observe(context.frozen, source, run, other.training, progress);
    std::string hashes = training.fingerprint;
    const RandomSplits splits = random_splits(training.features, context, worlds);
    const auto models = train_each(splits.training, context.training());
    const auto add = [&](const std::string& name, const WorldRows& rows) {
        row.domains.push_back(context.score(
            name, scores_of(judge_each(models, rows, context.run.threads), context.merged)));
    };
    add(std::string(nominal_condition), splits.validation);
    for (const std::string& name : context.experiment.protocol.variant_conditions)
        for (const Condition& condition : other.conditions) {
            if (condition.name != name) continue;
            const PassingRecording shifted =
                observe(context.frozen, source, run, condition, progress);
            hashes += shifted.fingerprint;
            add(name, rows_by_world(shifted.features, worlds));
        }
    row.fingerprint = sha256_of(hashes);
    return row;
}

double drawn(const Distribution::Uniform& law, Stream& stream) {
    return Distribution(law).sample(stream);
}

Assumption drawn_assumption(std::uint64_t seed, int draw) {
    Stream stream({.seed = seed,
                   .purpose = "prior over assumptions",
                   .item = static_cast<std::uint32_t>(draw)});
    Assumption assumption;
    const double size_m = drawn({0.12, 0.40}, stream);
    assumption.size_m = {size_m, size_m};
    assumption.snr_db = drawn({-30.0, 0.0}, stream);
    assumption.clutter_db = drawn({-10.0, 10.0}, stream);
    assumption.spread_factor = std::exp2(drawn({-1.0, 1.0}, stream));
    assumption.sessions = 4 + static_cast<int>(stream.below(13));
    assumption.window = stream.below(2) == 0 ? "hann" : "blackman";
    assumption.name = format("draw_{}", draw);
    assumption.title =
        format("{:.0f} cm, {:+.1f} dB, clutter {:+.1f} dB, spreads x{:.2f}, {} sessions, {}",
               100.0 * size_m, assumption.snr_db, assumption.clutter_db, assumption.spread_factor,
               *assumption.sessions, *assumption.window);
    return assumption;
}

}  // namespace

std::vector<SensitivityRow> sensitivity(const StudyContext& context) {
    const int worlds = std::min(context.extent.variant_worlds, context.run.worlds);
    std::vector<Assumption> assumptions{Assumption{}};
    const auto& variants = context.experiment.protocol.variants;
    assumptions.insert(assumptions.end(), variants.begin(), variants.end());
    const CalibrationOutcome& calibration = context.frozen.outcome();
    if (calibration.matching && !calibration.reached) {
        Assumption matching;
        matching.name = "snr_matching";
        matching.snr_db = calibration.matching->snr_db;
        // Fewer worlds score otherwise: the row itself need not show the paper's figure.
        matching.title = format("Signal-to-noise {:+.1f} dB ({} worlds: nominal {:.1f} %)",
                                calibration.matching->snr_db, context.run.worlds,
                                100.0 * calibration.matching->macro_f1);
        assumptions.push_back(matching);
    }
    const auto judged = judged_conditions(context);
    std::size_t n_sessions = 0;
    for (const Assumption& assumption : assumptions)
        n_sessions += sessions_of(under(assumption, context.experiment), judged, worlds);
    Progress progress("Varying assumptions", "sessions", n_sessions);
    std::vector<SensitivityRow> rows;
    for (const Assumption& assumption : assumptions)
        rows.push_back(row_under(assumption, context, worlds, progress));
    return rows;
}

PriorPrediction prior_prediction(const StudyContext& context, double paper_nominal) {
    PriorPrediction prior;
    prior.domains = context.experiment.protocol.variant_conditions;
    prior.tolerance = prior_tolerance;
    const auto judged = judged_conditions(context);
    const int draws = context.extent.prior_draws;
    std::size_t n_sessions = 0;
    for (int draw = 0; draw < draws; ++draw)
        n_sessions += sessions_of(
            under(drawn_assumption(context.run.seed, draw), context.experiment), judged, 1);
    Progress progress("Drawing assumptions", "sessions", n_sessions);
    for (int draw = 0; draw < draws; ++draw) {
        StudyContext one = context;
        // Each draw has samples and a room of its own.
        one.run.seed = context.run.seed + 1000003ull * static_cast<std::uint64_t>(draw + 1);
        const SensitivityRow row =
            row_under(drawn_assumption(context.run.seed, draw), one, 1, progress);
        PriorDraw result{.what = row.title, .nominal = row.domains.front().all.mean};
        for (std::size_t i = 1; i < row.domains.size(); ++i)
            result.domains.push_back(row.domains[i].all.mean);
        result.accepted = std::abs(result.nominal - paper_nominal) <= prior_tolerance;
        prior.draws.push_back(std::move(result));
    }
    return prior;
}

}  // namespace specula
