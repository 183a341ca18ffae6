#pragma once

#include <cstdint>
#include <vector>

#include "classifier/mlp_network.hpp"

namespace specula {

/// Adam's state for one network.
/// @eq  Kingma and Ba 2015, arXiv 1412.6980, algorithm 1: both moments bias-corrected, epsilon
///      outside the square root.
template <typename Scalar>
struct Adam {
    explicit Adam(const MlpNetwork<Scalar>& network);

    double learning_rate = 1e-3;
    std::int64_t n_steps = 0;
    std::vector<MlpLayer<Scalar>> mean;    ///< of the gradient
    std::vector<MlpLayer<Scalar>> square;  ///< mean of its square
};

/// Moves the network against `gradient` (layer), by about the learning rate per parameter.
template <typename Scalar>
void adam_step(const std::vector<MlpLayer<Scalar>>& gradient, Adam<Scalar>& adam,
               MlpNetwork<Scalar>& network);

}  // namespace specula
