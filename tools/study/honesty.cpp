#include "tools/study/honesty.hpp"

#include <algorithm>

#include "classifier/metrics.hpp"
#include "sim/core/format.hpp"
#include "sim/generate.hpp"
#include "tools/report/paired_difference.hpp"
#include "tools/study/judgement.hpp"
#include "tools/study/same_laws.hpp"
#include "tools/study/shuffled_labels.hpp"

namespace specula {

namespace {

using Band = std::array<double, 2>;

/// Half widths, after study plans of this kind: shuffled frames leave only sampling noise, whole
/// sessions are few and spread wider.
constexpr double frame_band = 0.03, session_band = 0.06;
constexpr double least_p = 0.01;

Band around(double share, double half_width) {
    return {share - half_width, share + half_width};
}

HonestyCheck checked(HonestyCheck check) {
    if (check.band)
        check.passed = check.value.high >= (*check.band)[0] && check.value.low <= (*check.band)[1];
    return check;
}

double chance(const StudyContext& context) {
    return 1.0 / static_cast<double>(context.experiment.population.classes.size());
}

/// Random frames are learnt from, the held-back ones judged.
WorldScores random_frame_scores(const WorldRows& rows, const StudyContext& context) {
    RandomSplits splits;
    for (std::size_t world = 0; world < rows.size(); ++world) {
        Split own = split_world(rows[world], static_cast<int>(world),
                                context.experiment.validation_share, context.run.seed);
        splits.training.push_back(std::move(own.training));
        splits.validation.push_back(std::move(own.validation));
    }
    const auto models = train_each(splits.training, context.training("checks"));
    return scores_of(judge_each(models, splits.validation, context.run.threads), context.merged);
}

void check_shuffles(const StudyContext& context, const CheckInput& input,
                    std::vector<HonestyCheck>& checks) {
    const WorldRows rows = rows_by_world(input.training.features, context.run.worlds);
    const auto mean = [&](const WorldScores& scores) {
        return bootstrap_mean(scores.all, context.bootstrap());
    };
    WorldRows frames;
    for (std::size_t world = 0; world < rows.size(); ++world)
        frames.push_back(
            with_shuffled_frames(rows[world], {.seed = context.run.seed,
                                               .purpose = "shuffled frames",
                                               .world = static_cast<std::uint32_t>(world)}));
    checks.push_back({.name = "shuffled_frames",
                      .title = "Classes shuffled among frames, random frames held back",
                      .value = mean(random_frame_scores(frames, context)),
                      .band = around(chance(context), frame_band),
                      .reason = "nothing is left to learn: chance"});
    if (context.experiment.training.sessions < 2) return;
    const WorldRows sessions = with_shuffled_sessions(rows, context);
    checks.push_back({.name = "shuffled_sessions_left_out",
                      .title = "Classes shuffled among sessions, whole sessions held back",
                      .value = mean(leave_sessions_out(sessions, context)),
                      .band = around(chance(context), session_band),
                      .reason = "no session says anything of another: chance"});
    checks.push_back({.name = "leak_meter",
                      .title = "Classes shuffled among sessions, random frames held back",
                      .value = mean(random_frame_scores(sessions, context)),
                      .reason = "what a random split scores for knowing sessions, not materials"});
    checks.push_back({.name = "sessions_left_out",
                      .title = "True classes, whole sessions held back",
                      .value = mean(leave_sessions_out(rows, context)),
                      .reason = "the honest counterpart of the nominal figure"});
}

HonestyCheck check_laws(const CheckInput& input, std::size_t n_classes) {
    const SameLaws laws = compare_nuisance(input.training.truth, n_classes);
    const double p = laws.corrected_p();
    return {.name = "same_nuisance",
            .title = "Nuisance laws alike for all classes (Kolmogorov-Smirnov, corrected p)",
            .value = {p, p, p},
            .band = Band{least_p, 1.0},
            .reason = laws.column.empty()
                          ? std::string("all laws are fixed values")
                          : format("{} tests; smallest p for {} of class {}", laws.n_tests,
                                   laws.column, input.training.features.class_names[laws.label]),
            .is_of_all_worlds_together = true};
}

HonestyCheck check_merging(const StudyContext& context, const CheckInput& input) {
    Interval smallest{1.0, 1.0, 1.0};
    std::string where;
    for (const DomainScore& score : input.scores) {
        const Interval gain = paired_difference(score.per_world.merged, score.per_world.all,
                                                context.run.seed)
                                  .value;
        if (gain.mean >= smallest.mean) continue;
        where = score.domain;
        smallest = gain;
    }
    const bool merges = !context.experiment.merged_classes.empty();
    return {.name = "merged_at_least",
            .title = "Merging classes costs nothing (smallest gain of all conditions)",
            .value = smallest,
            .band = merges ? std::optional(Band{-0.02, 1.0}) : std::nullopt,
            .reason = format("in {}; a mean over fewer classes may lose a point or two where one "
                             "class is never right",
                             where)};
}

/// The training condition of another population, and what is recorded anew: of the known pieces, or
/// of others.
struct OwnRecording {
    WorldRows training, anew;
};

/// Sessions that the training has not seen: numbered as the last condition.
Condition anew_of(const Condition& training, bool new_samples) {
    Condition anew = training;
    anew.number = Condition::most_conditions - 1;
    anew.sessions = std::max(1, training.sessions / 2);
    anew.frames = std::max(1, training.frames / 3);
    anew.new_samples = new_samples;
    return anew;
}

/// Which population, and on which pieces it is judged.
struct OwnPlan {
    Experiment experiment;
    bool new_samples = false;
};

OwnRecording record_own(const StudyContext& context, const OwnPlan& plan, int worlds,
                        Progress& progress) {
    const Source source{plan.experiment, context.materials};
    const RunSettings run = context.run_with(worlds);
    const Condition& training = plan.experiment.training;
    const auto rows = [&](const Condition& condition) {
        return rows_by_world(observe(context.frozen, source, run, condition, progress).features,
                             worlds);
    };
    return {rows(training), rows(anew_of(training, plan.new_samples))};
}

Interval score_own(const StudyContext& context, const OwnRecording& own) {
    const auto models = train_each(own.training, context.training("checks"));
    return bootstrap_mean(
        scores_of(judge_each(models, own.anew, context.run.threads), context.merged).all,
        context.bootstrap());
}

/// All of one material and one law; only the names of the classes differ.
Experiment all_of_one(const Experiment& experiment) {
    Experiment other = experiment;
    const auto& merged = experiment.merged_classes;
    const SampleLaw law = experiment.population.classes[merged.empty() ? 0 : merged.back()];
    for (SampleLaw& own : other.population.classes) {
        const std::string name = own.name;
        own = law;
        own.name = name;
    }
    return other;
}

/// The first two merged classes both of the second's material and law: two plates of one kind.
Experiment placebo_of(const Experiment& experiment) {
    Experiment other = experiment;
    SampleLaw& first = other.population.classes[experiment.merged_classes[0]];
    const std::string name = first.name;
    first = experiment.population.classes[experiment.merged_classes[1]];
    first.name = name;
    return other;
}

/// Every sample its nominal self, every session the drawing, no clutter, hardly any noise.
Experiment without_nuisance(const Experiment& experiment) {
    Experiment other = experiment;
    Assumption quiet;
    quiet.snr_db = 60.0;
    quiet.spread_factor = 0.0;
    other = under(quiet, other);
    other.population.frame = {};
    other.population.world_clutter.points = other.population.session_clutter.points = 0;
    return other;
}

void check_other_populations(const StudyContext& context, std::vector<HonestyCheck>& checks) {
    const int worlds = std::min(context.extent.check_worlds, context.run.worlds);
    if (worlds == 0) return;
    const Experiment& experiment = context.experiment;
    const bool pairs = experiment.merged_classes.size() >= 2;
    const Condition& training = experiment.training;
    const std::size_t n_sessions =
        (pairs ? 4u : 3u) *
        (session_count(training, experiment.population, worlds) +
         experiment.population.classes.size() * static_cast<std::size_t>(worlds) *
             static_cast<std::size_t>(std::max(1, training.sessions / 2)));
    Progress progress("Checking", "sessions", n_sessions);
    const auto run = [&](const OwnPlan& plan) {
        return score_own(context, record_own(context, plan, worlds, progress));
    };
    if (pairs) {
        const double distinct = 1.0 - chance(context);  // all others right, the pair at chance
        checks.push_back({.name = "placebo",
                          .title = "Two plates of one metal, recorded anew",
                          .value = run({placebo_of(experiment)}),
                          .band = around(distinct, session_band),
                          .reason = "a pair at chance and the rest right"});
    }
    checks.push_back({.name = "one_material",
                      .title = "All classes of one material, judged on other pieces",
                      .value = run({all_of_one(experiment), true}),
                      .band = around(chance(context), session_band),
                      .reason = "neither material nor piece tells classes apart: chance"});
    checks.push_back({.name = "one_material_known_pieces",
                      .title = "All classes of one material, the known pieces recorded anew",
                      .value = run({all_of_one(experiment), false}),
                      .reason = "what is learnt of pieces: bow, thickness, roughness"});
    checks.push_back({.name = "no_nuisance",
                      .title = "No noise, no clutter, no variation between sessions",
                      .value = run({without_nuisance(experiment)}),
                      .band = Band{0.999, 1.0},
                      .reason = "features and network lose nothing by themselves"});
}

/// How many worlds the checks stand on.
void count_worlds(const StudyContext& context, std::vector<HonestyCheck>& checks) {
    const auto all = static_cast<std::size_t>(context.run.worlds);
    const auto few = static_cast<std::size_t>(
        std::min(context.extent.check_worlds, context.run.worlds));
    const auto is_named = [](const HonestyCheck& check, std::initializer_list<const char*> names) {
        return std::ranges::any_of(names, [&](const char* name) { return check.name == name; });
    };
    for (HonestyCheck& check : checks) {
        const bool has_own_worlds = is_named(
            check, {"placebo", "one_material", "one_material_known_pieces", "no_nuisance"});
        check.n_worlds = has_own_worlds ? few : all;
    }
}

}  // namespace

std::vector<HonestyCheck> honesty_checks(const StudyContext& context, const CheckInput& input) {
    std::vector<HonestyCheck> checks;
    check_shuffles(context, input, checks);
    check_other_populations(context, checks);
    checks.push_back(check_merging(context, input));
    checks.push_back(check_laws(input, context.experiment.population.classes.size()));
    for (HonestyCheck& check : checks) check = checked(check);
    count_worlds(context, checks);
    return checks;
}

}  // namespace specula
