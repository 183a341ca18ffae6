#pragma once

#include <cstddef>
#include <vector>

#include "classifier/model.hpp"
#include "firmware/fw_mlp.h"

namespace specula {

/// x -> weight x + bias.
template <typename Scalar>
struct AffineLayer {
    std::size_t n_in = 0;
    std::size_t n_out = 0;
    std::vector<Scalar> weight;  ///< (out, in)
    std::vector<Scalar> bias;    ///< (out)
};

/// The linear part of a hidden layer with the batch normalisation before its ReLU, in double:
/// weight' = s weight, bias' = beta + s (bias - mean), with
/// s = gamma / sqrt(variance + batch_norm_epsilon). A convolution comes unrolled.
AffineLayer<double> folded(const HiddenLayer& layer);

/// All layers, in double. A normalisation of the inputs, or one behind a ReLU, goes into the layer
/// that follows it: weight' = weight diag(s), bias' = bias + weight (beta - s mean).
std::vector<AffineLayer<double>> folded_layers(const Model& model);

/// A model as the firmware runs it. Owns the arrays that `view` lends.
struct FoldedModel {
    std::vector<float> input_mean;   ///< (feature)
    std::vector<float> input_scale;  ///< (feature)
    std::vector<AffineLayer<float>> layers;

    std::size_t n_features() const { return layers.front().n_in; }
    std::size_t n_classes() const { return layers.back().n_out; }

    /// Points into this model's arrays: valid while they live, also after the model is moved.
    fw_mlp view() const&;
    fw_mlp view() const&& = delete;
};

/// Folds in double and rounds once to float.
/// @in  model  at most FW_MLP_MAX_LAYERS - 1 hidden layers, each at most 65535 wide
FoldedModel fold(const Model& model);

}  // namespace specula
