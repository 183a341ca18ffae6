#include "classifier/metrics.hpp"
#include "classifier/nearest_neighbours.hpp"
#include "sim/parallel.hpp"
#include "tools/report/result_figures.hpp"
#include "tools/study/honesty.hpp"

/// Classifiers that nobody would suspect of anything: what the network must be held against.
namespace specula {

namespace {

constexpr int n_neighbours = 5;

std::vector<double> neighbour_scores(const WorldRows& known, const WorldRows& rows, int threads) {
    std::vector<double> scores(known.size());
    const auto judge = [&](std::size_t world) {
        const NearestNeighbours neighbours(known[world], n_neighbours);
        scores[world] =
            macro_f1(confusion_of(rows[world].label, neighbours.predict(rows[world]).label,
                                  rows[world].class_names.size()));
    };
    for_each_index(known.size(), threads, judge);
    return scores;
}

}  // namespace

std::vector<HonestyCheck> simple_baselines(const StudyContext& context, const CheckInput& input) {
    const int worlds = context.run.worlds;
    const RandomSplits splits = random_splits(input.training.features, context, worlds);
    std::vector<std::pair<std::string, WorldRows>> domains{
        {std::string(nominal_condition), splits.validation}};
    for (const Recording* recording : input.conditions)
        domains.emplace_back(recording->condition.name, rows_by_world(recording->features, worlds));
    TrialTraining logistic = context.training("logistic");
    logistic.options.hidden.clear();
    const auto models = train_each(splits.training, logistic);
    const auto known_worlds = static_cast<std::size_t>(worlds);
    std::vector<HonestyCheck> checks;
    for (const auto& [name, rows] : domains) {
        const WorldScores linear =
            scores_of(judge_each(models, rows, context.run.threads), context.merged);
        checks.push_back({.name = "logistic_" + name,
                          .title = "Logistic regression, " + short_title(name),
                          .value = bootstrap_mean(linear.all, context.bootstrap()),
                          .reason = "a straight boundary between classes",
                          .n_worlds = known_worlds});
        checks.push_back(
            {.name = "neighbours_" + name,
             .title = "Five nearest neighbours, " + short_title(name),
             .value = bootstrap_mean(neighbour_scores(splits.training, rows, context.run.threads),
                                     context.bootstrap()),
             .reason = "no training at all",
             .n_worlds = known_worlds});
    }
    return checks;
}

}  // namespace specula
