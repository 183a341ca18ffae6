#pragma once

#include "classifier/metrics.hpp"
#include "classifier/predict.hpp"
#include "classifier/train.hpp"
#include "tests/classifier/blobs.hpp"
#include "tests/message_of.hpp"

namespace specula {

inline constexpr StreamKey training_key{.seed = 5, .purpose = "train test"};

inline double f1_on(const Model& model, const FeatureTable& rows) {
    const Predictions predictions = predict(fold(model), rows);
    return macro_f1(confusion_of(rows.label, predictions.label, model.n_classes()));
}

/// Why training on these rows is refused.
inline std::string problem_of(const FeatureTable& rows, const TrainOptions& options) {
    return message_of([&] { return train(rows, options, training_key).n_classes(); });
}

}  // namespace specula
