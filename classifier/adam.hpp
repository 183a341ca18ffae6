#pragma once

#include <cstdint>
#include <vector>

#include "classifier/mlp_network.hpp"

namespace specula {

/// Adam's state for one network, or AdamW's.
///
/// Decay is decoupled from the gradient and takes weights alone: neither biases nor what belongs to
/// a normalisation, whose size no weight before it depends on.
/// @eq  Kingma and Ba 2015, arXiv 1412.6980, algorithm 1: both moments bias-corrected, epsilon
///      outside the square root. Loshchilov and Hutter 2019, arXiv 1711.05101, algorithm 2.
template <typename Scalar>
struct Adam {
    explicit Adam(const MlpNetwork<Scalar>& network);

    double learning_rate = 1e-3;
    double weight_decay = 0.0;  ///< per unit of learning rate, >= 0; 0: Adam
    std::int64_t n_steps = 0;
    std::vector<MlpLayer<Scalar>> mean;    ///< of the gradient
    std::vector<MlpLayer<Scalar>> square;  ///< mean of its square
};

/// Moves the network against `gradient` (layer), by about the learning rate per parameter.
template <typename Scalar>
void adam_step(const std::vector<MlpLayer<Scalar>>& gradient, Adam<Scalar>& adam,
               MlpNetwork<Scalar>& network);

}  // namespace specula
