#pragma once

#include <atomic>
#include <string_view>
#include <vector>

#include "classifier/evaluate.hpp"
#include "classifier/model.hpp"
#include "classifier/train.hpp"
#include "tools/report/study_results.hpp"

namespace specula {

/// A table per world.
using WorldRows = std::vector<FeatureTable>;

/// The rows of each of the first `worlds` worlds, in their order.
WorldRows rows_by_world(const FeatureTable& rows, int worlds);

/// How models of a trial are trained; `threads` changes no result.
struct TrialTraining {
    TrainOptions options;
    std::uint64_t seed = 1;
    std::string_view purpose = "training";
    int repeat = 0;  ///< which of several trainings on the same rows
    int threads = 1;
};

/// One model per world, each trained on its own world's rows.
std::vector<Model> train_each(const WorldRows& rows, const TrialTraining& training,
                              std::atomic<std::size_t>* done = nullptr);

/// What each world's model makes of that world's rows.
std::vector<WorldOutcome> judge_each(const std::vector<Model>& models, const WorldRows& rows,
                                     int threads);

/// Macro-F1 world by world.
/// @in  merged  (class) -> merged class
WorldScores scores_of(const std::vector<WorldOutcome>& outcomes, std::span<const int> merged);

/// Mean over repeats, world by world.
WorldScores mean_scores(const std::vector<WorldScores>& repeats);

}  // namespace specula
