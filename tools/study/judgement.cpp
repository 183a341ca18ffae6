#include "tools/study/judgement.hpp"

#include "sim/parallel.hpp"

namespace specula {

Split split_world(const FeatureTable& recorded, int world, double validation_share,
                  std::uint64_t seed) {
    const FeatureTable rows =
        select_rows_where(recorded, [&](std::size_t i) { return recorded.world[i] == world; });
    Stream stream({.seed = seed,
                   .purpose = "validation split",
                   .world = static_cast<std::uint32_t>(world)});
    std::vector<std::size_t> training, validation;
    for (std::size_t i = 0; i < rows.size(); ++i)
        (stream.uniform() < validation_share ? validation : training).push_back(i);
    // Of a few frames, chance may leave one side nothing.
    const auto share_one = [](std::vector<std::size_t>& from, std::vector<std::size_t>& to) {
        if (!to.empty() || from.empty()) return;
        to.push_back(from.back());
        from.pop_back();
    };
    share_one(training, validation);
    share_one(validation, training);
    return {select_rows(rows, training), select_rows(rows, validation)};
}

std::vector<Model> train_worlds(const std::vector<Split>& splits, const TrainOptions& options,
                                const RunSettings& run, Progress& progress) {
    std::vector<Model> models(splits.size());
    const auto train_one = [&](std::size_t world) {
        models[world] = train(splits[world].training, options,
                              {.seed = run.seed,
                               .purpose = "training",
                               .world = static_cast<std::uint32_t>(world)});
    };
    for_each_index(splits.size(), run.threads, train_one, &progress.done());
    return models;
}

std::vector<WorldOutcome> judge(const std::vector<Model>& models, const FeatureTable& rows,
                                const RunSettings& run) {
    std::vector<WorldOutcome> outcomes(models.size());
    const auto judge_one = [&](std::size_t world) {
        const FeatureTable own = select_rows_where(
            rows, [&](std::size_t i) { return rows.world[i] == static_cast<int>(world); });
        outcomes[world] = {own.label, predict(fold(models[world]), own)};
    };
    for_each_index(models.size(), run.threads, judge_one);
    return outcomes;
}

}  // namespace specula
