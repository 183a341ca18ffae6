#pragma once

#include "classifier/model.hpp"

namespace specula {

/// A convolution as the layer without neighbourhoods that computes the same: its weights repeated
/// at every position, zeros where nothing is seen. Other layers as they are.
HiddenLayer unrolled(const HiddenLayer& layer);

/// The same model without convolutions, so that whatever runs plain layers runs it: the firmware,
/// its blob, ONNX. Exact, at the price of the zeros.
Model unrolled(const Model& model);

/// What a model costs per answer.
struct ModelCost {
    std::size_t multiply_accumulates = 0;
    std::size_t parameters = 0;  ///< weights and biases, normalisation folded
    /// Those of the unrolled model, as the firmware runs it; equal without convolutions.
    std::size_t unrolled_multiply_accumulates = 0;
    std::size_t unrolled_parameters = 0;
};
ModelCost cost_of(const Model& model);

}  // namespace specula
