#pragma once

#include <atomic>
#include <vector>

#include "classifier/feature_table.hpp"
#include "classifier/model.hpp"
#include "classifier/train_options.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// How a training went, epoch by epoch.
struct TrainingCurve {
    std::vector<double> loss;           ///< (epoch), mean over its batches, nats
    std::vector<double> held_out_loss;  ///< (epoch), nats; empty: nothing was held out
    int best_epoch = 0;                 ///< from 1: whose network was kept
};

/// What goes with a training, if wanted.
struct Watched {
    /// Rows that end the training (TrainOptions::patience), rather than sessions of the training
    /// rows; same features and classes.
    const FeatureTable* held_out = nullptr;
    std::atomic<std::size_t>* epochs_done = nullptr;  ///< counted up
    TrainingCurve* curve = nullptr;                   ///< written
};

/// A classifier of these rows: mini-batch Adam or AdamW on the cross-entropy, on one thread.
///
/// The standardiser is fitted on these rows only. Every epoch shuffles the rows and parts them into
/// batches that differ by one row at most, so that no small batch spoils the statistics. Weights,
/// shuffles and mixtures are drawn from the one stream of `key`: the same rows, options and key
/// give the same bytes, whatever else runs. (Another compiler may round otherwise.)
///
/// With patience, whole sessions are held out (hold_out_sessions) unless `watched` brings rows; the
/// network of the epoch with their lowest loss is kept, and the standardiser and the input monitor
/// see the other rows alone.
/// @in   rows  at least 2 of at least two classes, features finite, labels < class_names.size()
/// @out  parameters finite; provenance names options, key, version and the kept epoch's loss
/// Throws InputError where an option is out of range, nothing can be learnt from the rows, or
/// training diverges.
Model train(const FeatureTable& rows, const TrainOptions& options, const StreamKey& key,
            const Watched& watched = {});

}  // namespace specula
