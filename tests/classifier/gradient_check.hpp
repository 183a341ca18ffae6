#pragma once

#include <algorithm>

#include "classifier/mlp_network.hpp"

namespace specula {

/// How close a value before a ReLU is to zero, where a difference quotient is not the slope.
inline double distance_from_kinks(const MlpNetwork<double>& network,
                                  const MlpWorkspace<double>& workspace) {
    double nearest = 1e9;
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const auto& layer = network.layers[l];
        const Matrix<double> before =
            (workspace.hidden[l].normalised.array().colwise() * layer.gamma.array()).colwise() +
            layer.beta.array();
        nearest = std::min(nearest, before.cwiseAbs().minCoeff());
    }
    return nearest;
}

}  // namespace specula
