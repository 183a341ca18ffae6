#pragma once

#include <cstdint>
#include <vector>

#include "classifier/folded_model.hpp"
#include "firmware/fw_int_mlp.h"

namespace specula {

/// One layer in integers, its rows padded as fw_int_layer wants them.
struct IntegerLayer {
    std::size_t n_in = 0;
    std::size_t n_out = 0;
    std::vector<std::int8_t> bytes;    ///< (out, stride), for int8
    std::vector<std::int16_t> halves;  ///< (out, stride), for int16
    std::vector<std::int32_t> bias;
    std::vector<std::int32_t> multiplier;  ///< hidden layers only, like shift
    std::vector<std::int32_t> shift;
    std::vector<float> scale;  ///< last layer only
};

/// A model as fw_int_mlp_run runs it. Owns the arrays that `view` lends.
struct IntegerModel {
    fw_int_width width = FW_INT16;
    std::vector<float> input_mean;
    std::vector<float> input_scale;
    float input_levels = 0.0f;
    std::vector<IntegerLayer> layers;

    fw_int_mlp view() const&;
    fw_int_mlp view() const&& = delete;
};

/// Quantises the folded model without data: every row of weights has its own step, and the values
/// between layers reach to beta + 6 |gamma| of the widest unit, where batch normalisation says that
/// they end. Standardised inputs reach to +-6. Without a normalisation before the ReLU, a layer's
/// reach is the largest its weights allow.
///
/// Steps are widened where 32-bit sums could overflow, so fw_int_layer_check accepts every layer.
/// @eq  M. Nagel et al., ICCV 2019, arXiv 1906.04721, section 4.2.1 (ranges of n = 6 sigma)
IntegerModel quantise(const Model& model, fw_int_width width);

}  // namespace specula
