#include "tools/study/ladder.hpp"

#include <algorithm>

#include "classifier/descriptor.hpp"
#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"
#include "sim/generate.hpp"
#include "sim/parallel.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

namespace {

/// Worst conditions that differ by less are taken for equal.
constexpr double equal_within = 0.005;

/// As many rows as asked for, spread evenly; all where there are fewer.
FeatureTable thinned(const FeatureTable& rows, std::size_t n_wanted) {
    if (rows.size() <= n_wanted) return rows;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < n_wanted; ++i) indices.push_back(i * rows.size() / n_wanted);
    return select_rows(rows, indices);
}

Experiment with_laws_of(const TrainingSet& set, const Experiment& experiment) {
    Experiment other = experiment;
    if (set.height_m) other.population.session.height_m = *set.height_m;
    if (set.tilt_rad) other.population.session.tilt_rad = *set.tilt_rad;
    return other;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
    return differences;
}

std::vector<double> values_of(const std::vector<double>& per_world,
                              const std::vector<std::size_t>& worlds) {
    std::vector<double> values;
    for (const std::size_t world : worlds) values.push_back(per_world[world]);
    return values;
}

double worst_merged(const LadderRung& rung, const std::vector<std::size_t>& worlds) {
    double worst = 1.0;
    for (const DomainScore& score : rung.domains) {
        double sum = 0.0;
        for (const double value : values_of(score.per_world.merged, worlds)) sum += value;
        worst = std::min(worst, sum / static_cast<double>(worlds.size()));
    }
    return worst;
}

}  // namespace

std::vector<std::size_t> choosing_worlds(std::size_t n_worlds) {
    std::vector<std::size_t> worlds{0};
    for (std::size_t world = 2; world < n_worlds; world += 2) worlds.push_back(world);
    return worlds;
}

void recommend(std::vector<LadderRung>& rungs, const std::vector<std::size_t>& worlds) {
    LadderRung* best = nullptr;
    for (LadderRung& rung : rungs) {
        // What needs the true gain, which nobody has, is no remedy.
        if (rung.descriptor.ends_with("over the true gain")) continue;
        const double gain = best ? worst_merged(rung, worlds) - worst_merged(*best, worlds) : 1.0;
        const bool cheaper = best && rung.cost.multiplications < best->cost.multiplications;
        if (gain > equal_within || (gain > -equal_within && cheaper)) best = &rung;
    }
    if (best) best->recommended = true;
}

/// Every rung on the worlds that decide nothing.
void Ladder::confirm(std::vector<LadderRung>& rungs) const {
    std::vector<std::size_t> others;
    for (std::size_t world = 1; world < static_cast<std::size_t>(context_.run.worlds); world += 2)
        others.push_back(world);
    if (others.empty()) return;
    for (LadderRung& rung : rungs)
        for (const DomainScore& score : rung.domains)
            rung.confirmed.push_back(
                context_.score(score.domain, {values_of(score.per_world.all, others),
                                              values_of(score.per_world.merged, others)}));
}

Ladder::Ladder(const StudyContext& context, const LadderInput& input)
    : context_(context), input_(input) {
    record_sets();
    record_motion();
}

void Ladder::record_sets() {
    const Experiment& experiment = context_.experiment;
    std::size_t n_sessions = 0;
    for (const TrainingSet& set : experiment.protocol.training_sets)
        n_sessions += session_count(set.condition, experiment.population, context_.run.worlds);
    Progress progress("Recording for remedies", "sessions", n_sessions);
    for (const TrainingSet& set : experiment.protocol.training_sets) {
        const Experiment own = with_laws_of(set, experiment);
        sets_[set.condition.name] = observe(context_.frozen, {own, context_.materials},
                                            context_.run, set.condition, progress);
    }
}

/// The same sessions again, but for what moves while frames are taken.
void Ladder::record_motion() {
    const auto& rungs = context_.experiment.protocol.rungs;
    if (std::ranges::none_of(rungs, [](const RungPlan& rung) { return rung.motion; })) return;
    Experiment moving = context_.experiment;
    moving.population.frame = *moving.protocol.motion;
    RunSettings run = context_.run;
    run.kinds.clear();
    for (const RungPlan& rung : rungs)
        if (rung.motion) run.kinds.push_back(rung.kind());
    std::vector<Condition> conditions{moving.training};
    for (const Recording* recording : input_.conditions) conditions.push_back(recording->condition);
    std::size_t n_sessions = 0;
    for (const Condition& condition : conditions)
        n_sessions += session_count(condition, moving.population, run.worlds);
    Progress progress("Recording in motion", "sessions", n_sessions);
    for (const Condition& condition : conditions)
        motion_[condition.name] =
            observe(context_.frozen, {moving, context_.materials}, run, condition, progress);
}

const FeatureTable& Ladder::table_of(const RungPlan& rung, const Recording& recording) const {
    return rung.motion ? motion_.at(recording.condition.name).described.at(rung.kind())
                       : recording.described.at(rung.kind());
}

RungRows Ladder::rows_of(const RungPlan& rung) const {
    const int worlds = context_.run.worlds;
    const RandomSplits splits = random_splits(table_of(rung, input_.training), context_, worlds);
    RungRows rows{.training = splits.training,
                  .domains = {std::string(nominal_condition)},
                  .judged = {splits.validation}};
    const auto set = sets_.find(rung.training);
    if (set != sets_.end()) {
        const WorldRows own = rows_by_world(set->second.described.at(rung.kind()), worlds);
        for (std::size_t world = 0; world < own.size(); ++world)
            rows.training[world] = thinned(
                own[world], static_cast<std::size_t>(
                                rung.budget * static_cast<double>(splits.training[world].size())));
    }
    for (const Recording* recording : input_.conditions) {
        rows.domains.push_back(recording->condition.name);
        rows.judged.push_back(rows_by_world(table_of(rung, *recording), worlds));
    }
    return rows;
}

TrialTraining Ladder::training_of(const RungPlan& rung, int repeat) const {
    TrialTraining how = context_.training();
    const int looks = parse_descriptor(rung.descriptor).looks;
    how.options = rung.options;
    how.options.epochs = context_.extent.epochs * looks;  // fewer rows, as many steps
    how.repeat = repeat;
    return how;
}

std::vector<Model> Ladder::models_of(const RungPlan& rung) const {
    return train_each(rows_of(rung).training, training_of(rung, 0));
}

std::vector<LadderRung> Ladder::run() const {
    const auto& plans = context_.experiment.protocol.rungs;
    const auto n_worlds = static_cast<std::size_t>(context_.run.worlds);
    const auto repeats = static_cast<std::size_t>(context_.extent.seeds);
    Progress progress("Training remedies", "classifiers", plans.size() * n_worlds * repeats);
    std::vector<LadderRung> rungs;
    for (const RungPlan& plan : plans) {
        const RungRows rows = rows_of(plan);
        std::vector<std::vector<WorldScores>> scores(rows.domains.size());  // (domain, repeat)
        for (std::size_t repeat = 0; repeat < repeats; ++repeat) {
            const auto models = train_each(
                rows.training, training_of(plan, static_cast<int>(repeat)), &progress.done());
            for (std::size_t domain = 0; domain < rows.domains.size(); ++domain)
                scores[domain].push_back(
                    scores_of(judge_each(models, rows.judged[domain], context_.run.threads),
                              context_.merged));
            if (repeat > 0) continue;
            rungs.push_back({.name = plan.name,
                             .title = plan.title,
                             .training = plan.training,
                             .descriptor = plan.kind(),
                             .budget = plan.budget,
                             .cost = cost_of(plan, models.front(),
                                             static_cast<int>(context_.experiment.radar.rx.size()) *
                                                 context_.experiment.radar.chirps_per_frame)});
        }
        LadderRung& rung = rungs.back();
        for (std::size_t domain = 0; domain < rows.domains.size(); ++domain)
            rung.domains.push_back(
                context_.score(rows.domains[domain], mean_scores(scores[domain])));
        const LadderRung& baseline = rungs.front();
        for (std::size_t domain = 0; domain < rows.domains.size(); ++domain) {
            const WorldScores& own = rung.domains[domain].per_world;
            const WorldScores& other = baseline.domains[domain].per_world;
            rung.gain.push_back(
                bootstrap_mean(difference(own.all, other.all), context_.bootstrap()));
            rung.gain_merged.push_back(
                bootstrap_mean(difference(own.merged, other.merged), context_.bootstrap()));
        }
    }
    recommend(rungs, choosing_worlds(n_worlds));
    confirm(rungs);
    return rungs;
}

}  // namespace specula
