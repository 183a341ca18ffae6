#pragma once

#include <cstdint>
#include <vector>

#include "classifier/feature_table.hpp"
#include "classifier/folded_model.hpp"

namespace specula {

/// What the firmware's network says about rows of a FeatureTable.
struct Predictions {
    std::size_t n_classes = 0;
    std::vector<std::uint8_t>
        label;  ///< (example), the class of the largest logit, the first of equals
    std::vector<float> probability;  ///< (example), of that class, by softmax
    std::vector<float> logits;       ///< (example, class), row-major

    std::size_t size() const { return label.size(); }
};

/// Runs every row through fw_mlp_run: the very code that runs on the chip.
/// @in  rows  n_features as the model's
/// Throws InputError where a row is not finite or so far off that its logits are not.
Predictions predict(const FoldedModel& model, const FeatureTable& rows);

}  // namespace specula
