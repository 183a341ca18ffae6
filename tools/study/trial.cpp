#include "tools/study/trial.hpp"

#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"
#include "sim/parallel.hpp"

namespace specula {

WorldRows rows_by_world(const FeatureTable& rows, int worlds) {
    std::vector<std::vector<std::size_t>> indices(static_cast<std::size_t>(worlds));
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows.world[i] >= 0 && rows.world[i] < worlds)
            indices[static_cast<std::size_t>(rows.world[i])].push_back(i);
    WorldRows tables;
    for (const auto& own : indices) tables.push_back(select_rows(rows, own));
    return tables;
}

std::vector<Model> train_each(const WorldRows& rows, const TrialTraining& training,
                              std::atomic<std::size_t>* done) {
    std::vector<Model> models(rows.size());
    const auto train_one = [&](std::size_t world) {
        models[world] = train(rows[world], training.options,
                              {.seed = training.seed,
                               .purpose = training.purpose,
                               .world = static_cast<std::uint32_t>(world),
                               .item = static_cast<std::uint32_t>(training.repeat)});
    };
    for_each_index(rows.size(), training.threads, train_one, done);
    return models;
}

std::vector<WorldOutcome> judge_each(const std::vector<Model>& models, const WorldRows& rows,
                                     int threads) {
    SPECULA_EXPECT(models.size() == rows.size());
    std::vector<WorldOutcome> outcomes(models.size());
    const auto judge_one = [&](std::size_t world) {
        outcomes[world] = {rows[world].label, predict(fold(models[world]), rows[world])};
    };
    for_each_index(models.size(), threads, judge_one);
    return outcomes;
}

WorldScores scores_of(const std::vector<WorldOutcome>& outcomes, std::span<const int> merged) {
    WorldScores scores;
    for (const WorldOutcome& world : outcomes) {
        const Confusion confusion =
            confusion_of(world.truth, world.predictions.label, world.predictions.n_classes);
        scores.all.push_back(macro_f1(confusion));
        scores.merged.push_back(macro_f1(merge_classes(confusion, merged)));
    }
    return scores;
}

WorldScores mean_scores(const std::vector<WorldScores>& repeats) {
    SPECULA_EXPECT(!repeats.empty());
    WorldScores mean = repeats.front();
    const double n = static_cast<double>(repeats.size());
    for (std::size_t world = 0; world < mean.all.size(); ++world) {
        mean.all[world] = mean.merged[world] = 0.0;
        for (const WorldScores& repeat : repeats) {
            mean.all[world] += repeat.all[world] / n;
            mean.merged[world] += repeat.merged[world] / n;
        }
    }
    return mean;
}

}  // namespace specula
