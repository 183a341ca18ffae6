#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "classifier/feature_table.hpp"
#include "classifier/report.hpp"
#include "classifier/train.hpp"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// What is kept together when frames are parted into those to learn from and those to judge by.
enum class LeaveOut {
    frame,    ///< nothing: frames of one recording are on both sides, and the score is too good
    session,  ///< a placement
    view,     ///< a side from which all samples are seen
    sample,   ///< a physical piece
};

/// The group of every frame. Throws InputError where the dataset does not tell views apart, or
/// where it holds a single group.
std::vector<std::int32_t> groups_of(const Dataset& dataset, LeaveOut what);

/// Throws InputError `what: problem; remedy` where a class lies in one group alone: with that left
/// out, nothing of the class is learnt from, and none of its frames can be recognised.
/// @in  group  (example), as groups_of gives it
void expect_groups_in_classes(const FeatureTable& rows, std::span<const std::int32_t> group,
                              LeaveOut what);

/// Parts groups into folds, one group never over two: groups sorted by class, then by number, are
/// dealt round; single frames by chance.
/// @in   n_folds  >= 2; fewer groups make fewer folds
/// @out  (example), from 0
std::vector<int> deal_folds(const FeatureTable& rows, std::span<const std::int32_t> group,
                            int n_folds);

/// The same table with the classes of the pieces shuffled among the pieces: what is left of the
/// score then was learnt from pieces, not from classes.
/// @in  sample  (example), the piece
FeatureTable with_shuffled_classes(const FeatureTable& rows, std::span<const std::int32_t> sample,
                                   const StreamKey& key);

struct CrossValidation {
    std::vector<int> fold;  ///< (example)
    int n_folds = 0;
    TrainOptions options;
    int neighbours = 0;  ///< above 0: so many nearest neighbours answer, and nothing is trained
    std::uint64_t seed = 1;
    int threads = 1;
};

/// Every example's class as a model says it that was trained without the example's fold.
/// Throws InputError where a fold leaves nothing to learn from, see check_training_rows.
/// @out  (example)
std::vector<std::uint8_t> cross_predict(const FeatureTable& rows, const CrossValidation& how,
                                        std::atomic<std::size_t>* done = nullptr);

/// Share of right answers, in [0, 1].
double accuracy(std::span<const std::uint8_t> truth, std::span<const std::uint8_t> predicted);

}  // namespace specula
