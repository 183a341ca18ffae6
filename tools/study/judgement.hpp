#pragma once

#include "classifier/evaluate.hpp"
#include "classifier/model.hpp"
#include "tools/study/recordings.hpp"

namespace specula {

/// The training recordings of one world, parted at random by frames, as a paper does that splits
/// its recordings without looking at sessions. Of two rows or more, neither part is empty.
struct Split {
    FeatureTable training;
    FeatureTable validation;
};
Split split_world(const FeatureTable& recorded, int world, double validation_share,
                  std::uint64_t seed);

/// One classifier per world, each trained on its own world's frames.
std::vector<Model> train_worlds(const std::vector<Split>& splits, const TrainOptions& options,
                                const RunSettings& run, Progress& progress);

/// What each world's own model makes of that world's rows.
std::vector<WorldOutcome> judge(const std::vector<Model>& models, const FeatureTable& rows,
                                const RunSettings& run);

}  // namespace specula
