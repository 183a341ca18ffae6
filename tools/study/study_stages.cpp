#include "tools/study/study_stages.hpp"

#include <cmath>

#include "classifier/nearest_neighbours.hpp"
#include "classifier/session_bootstrap.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/study/study_facts.hpp"

namespace specula {

namespace {

FeatureTable joined(const WorldRows& worlds) {
    FeatureTable rows = worlds.front();
    for (std::size_t world = 1; world < worlds.size(); ++world) {
        const FeatureTable& more = worlds[world];
        rows.features.insert(rows.features.end(), more.features.begin(), more.features.end());
        rows.label.insert(rows.label.end(), more.label.begin(), more.label.end());
        rows.world.insert(rows.world.end(), more.world.begin(), more.world.end());
        rows.session.insert(rows.session.end(), more.session.begin(), more.session.end());
    }
    return rows;
}

/// Mean over repeats of a macro-F1 of sessions put together.
WorldValue mean_of(const std::vector<WorldValue>& repeats) {
    return [repeats](std::span<const std::size_t> sessions) {
        double sum = 0.0;
        for (const WorldValue& repeat : repeats) sum += repeat(sessions);
        return sum / static_cast<double>(repeats.size());
    };
}

std::vector<std::uint8_t> joined_labels(const std::vector<WorldOutcome>& outcomes) {
    std::vector<std::uint8_t> labels;
    for (const WorldOutcome& world : outcomes)
        labels.insert(labels.end(), world.predictions.label.begin(), world.predictions.label.end());
    return labels;
}

/// Counts are those of the first repeat; macro-F1 is the mean over repeats, its interval drawn over
/// worlds and within them over sessions.
void set_intervals(const StudyContext& context, const WorldRows& rows,
                   const std::vector<std::vector<WorldOutcome>>& repeats, ConditionReport& report) {
    const FeatureTable all = joined(rows);
    const SessionTree tree = session_tree_of(all);
    std::vector<WorldValue> plain, merged;
    for (const auto& outcomes : repeats) {
        const auto confusions = confusion_per_session(tree, all, joined_labels(outcomes));
        plain.push_back(macro_f1_value(confusions));
        merged.push_back(macro_f1_value(confusions, context.merged));
    }
    const Resampling resampling{.key = context.bootstrap()};
    report.macro_f1 = bootstrap_sessions(tree, mean_of(plain), resampling);
    report.macro_f1_merged = bootstrap_sessions(tree, mean_of(merged), resampling);
}

struct Named {
    std::string name, title;
    std::vector<double> heights_m;
};

/// What all models say of one table of every world.
struct Judged {
    StudyCondition condition;
    std::vector<WorldOutcome> outcomes;
    WorldScores scores;
};

Judged judge_table(const StudyContext& context, const Baseline& baseline, const Named& named,
                   const WorldRows& rows) {
    std::vector<std::vector<WorldOutcome>> outcomes{
        judge_each(baseline.models, rows, context.run.threads)};
    for (const auto& models : baseline.repeats)
        outcomes.push_back(judge_each(models, rows, context.run.threads));
    std::vector<WorldScores> repeats;
    for (const auto& repeat : outcomes) repeats.push_back(scores_of(repeat, context.merged));
    Judged judged;
    judged.scores = mean_scores(repeats);
    StudyCondition& condition = judged.condition;
    condition.result =
        evaluate(named.name, named.title, outcomes.front(), {context.merged, context.bootstrap()});
    condition.result.macro_f1_per_world = judged.scores.all;
    condition.result.macro_f1_merged_per_world = judged.scores.merged;
    set_intervals(context, rows, outcomes, condition.result);
    judged.outcomes = std::move(outcomes.front());
    condition.heights_m = named.heights_m;
    const auto paper = context.experiment.paper_macro_f1.find(named.name);
    if (paper != context.experiment.paper_macro_f1.end()) condition.paper_macro_f1 = paper->second;
    return judged;
}

/// "height 35 cm", "tilt_sensor +10 deg": a condition at one of its geometries.
Named part_of(const Condition& condition, int geometry) {
    const auto n_tilts = static_cast<int>(condition.tilts_rad.size());
    const double height_m = condition.heights_m[static_cast<std::size_t>(geometry / n_tilts)];
    const double tilt_rad = condition.tilts_rad[static_cast<std::size_t>(geometry % n_tilts)];
    std::string which;
    if (condition.heights_m.size() > 1) which += format(" {:g} cm", 100.0 * height_m);
    if (n_tilts > 1) which += format(" {:+g}\u00b0", tilt_rad * 180.0 / pi);
    return {condition.name + which, condition.title + ":" + which, {height_m}};
}

}  // namespace

Baseline train_baseline(const StudyContext& context, const Recording& training) {
    Baseline baseline;
    baseline.splits = random_splits(training.features, context, context.run.worlds);
    const auto repeats = static_cast<std::size_t>(context.extent.seeds);
    Progress progress("Training", "classifiers", repeats * baseline.splits.training.size());
    for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
        TrialTraining how = context.training();
        how.repeat = static_cast<int>(repeat);
        auto models = train_each(baseline.splits.training, how, &progress.done());
        if (repeat == 0) {
            for (std::size_t world = 0; world < models.size(); ++world)
                models[world].prototypes =
                    kept(fit_prototypes(baseline.splits.training[world], {},
                                        {.seed = context.run.seed,
                                         .purpose = "prototypes",
                                         .world = static_cast<std::uint32_t>(world)}));
            baseline.models = std::move(models);
        } else {
            baseline.repeats.push_back(std::move(models));
        }
    }
    return baseline;
}

void judge_conditions(const StudyContext& context, const std::vector<Recording>& recordings,
                      Baseline& baseline, StudySummary& summary) {
    const auto add = [&](const Named& named, WorldRows rows, const FeatureTable& all) {
        Judged judged = judge_table(context, baseline, named, rows);
        judged.condition.features = profiles_of(all);
        summary.conditions.push_back(std::move(judged.condition));
        baseline.domains.push_back(named.name);
        // One interval for one quantity, wherever it is shown: over worlds and their sessions.
        const ConditionReport& result = summary.conditions.back().result;
        baseline.scores.push_back({.domain = named.name,
                                   .all = result.macro_f1,
                                   .merged = result.macro_f1_merged,
                                   .per_world = judged.scores});
        baseline.outcomes.push_back(std::move(judged.outcomes));
        baseline.rows.push_back(std::move(rows));
    };
    const Experiment& experiment = context.experiment;
    add({std::string(nominal_condition),
         experiment.validation_title,
         {experiment.nominal_height_m}},
        baseline.splits.validation, joined(baseline.splits.validation));
    for (std::size_t i = 1; i < recordings.size(); ++i) {
        const Recording& recording = recordings[i];
        const Condition& condition = recording.condition;
        add({condition.name, condition.title, condition.heights_m},
            rows_by_world(recording.features, context.run.worlds), recording.features);
        for (int geometry = 0; geometry < condition.geometries(); ++geometry) {
            if (condition.geometries() == 1) continue;
            const WorldRows rows = rows_by_world(
                rows_of_geometry(recording.features, condition, geometry), context.run.worlds);
            summary.parts.push_back(
                judge_table(context, baseline, part_of(condition, geometry), rows).condition);
        }
    }
}

}  // namespace specula
