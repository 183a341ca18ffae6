#pragma once

#include <vector>

#include "classifier/feature_table.hpp"
#include "classifier/model.hpp"
#include "sim/core/random.hpp"

namespace specula {

struct TrainOptions {
    std::vector<int> hidden{16, 16};  ///< units per hidden layer; none: logistic regression
    int epochs = 60;                  ///< passes over the rows, >= 1
    int batch_size = 128;             ///< >= 2; batches are made equal, so about this
    double learning_rate = 1e-3;      ///< of Adam, > 0
};

/// A classifier of these rows: mini-batch Adam on the cross-entropy, in float, on one thread.
///
/// The standardiser is fitted on these rows only. Every epoch shuffles the rows and parts them into
/// batches that differ by one row at most, so that no small batch spoils the statistics. Weights
/// and shuffles are drawn from the one stream of `key`: the same rows, options and key give the
/// same bytes, whatever else runs. (Another compiler may round otherwise.)
/// @in   rows  at least 2, features finite, labels < class_names.size()
/// @out  parameters finite; provenance names options, key and the last epoch's loss
/// Throws InputError where an option is out of range, rows are too few, or training diverges.
Model train(const FeatureTable& rows, const TrainOptions& options, const StreamKey& key);

}  // namespace specula
