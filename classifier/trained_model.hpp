#pragma once

#include "classifier/mlp_network.hpp"
#include "classifier/model.hpp"

namespace specula {

/// The layers of a trained network, rounded to float; all else of the model is left empty.
template <typename Scalar>
Model model_of(const MlpNetwork<Scalar>& network);

/// Whether every parameter and running statistic is finite.
template <typename Scalar>
bool is_finite(const MlpNetwork<Scalar>& network);

}  // namespace specula
