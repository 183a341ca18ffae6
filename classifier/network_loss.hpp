#pragma once

#include <cmath>

#include "classifier/mlp_network.hpp"

namespace specula {

/// Mean cross-entropy of a batch by log-sum-exp; leaves d loss / d logit.
/// @eq  smoothing: Szegedy et al. 2016, arXiv 1512.00567, section 7
template <typename Scalar>
double cross_entropy(MlpWorkspace<Scalar>& w) {
    auto logits = w.logits.leftCols(w.n_examples);
    auto gradient = w.logit_gradient.leftCols(w.n_examples);
    const double own = (1.0 - w.smoothing) * w.own_share;
    const double other = (1.0 - w.smoothing) * (1.0 - w.own_share);
    const double every = w.smoothing / static_cast<double>(logits.rows());
    for (Eigen::Index j = 0; j < w.n_examples; ++j)
        gradient.col(j).array() = logits.col(j).array() - logits.col(j).maxCoeff();
    double loss = 0.0;
    for (Eigen::Index j = 0; j < w.n_examples; ++j) {
        const auto column = static_cast<std::size_t>(j);
        loss -= own * static_cast<double>(gradient(w.label[column], j));
        if (other > 0.0) loss -= other * static_cast<double>(gradient(w.other_label[column], j));
        if (every > 0.0) loss -= every * static_cast<double>(gradient.col(j).sum());
    }
    gradient = gradient.array().exp();
    const double inverse_n = 1.0 / static_cast<double>(w.n_examples);
    for (Eigen::Index j = 0; j < w.n_examples; ++j) {
        const auto column = static_cast<std::size_t>(j);
        const Scalar sum = gradient.col(j).sum();
        loss += std::log(static_cast<double>(sum));
        gradient.col(j) *= static_cast<Scalar>(inverse_n) / sum;
        gradient(w.label[column], j) -= static_cast<Scalar>(own * inverse_n);
        if (other > 0.0)
            gradient(w.other_label[column], j) -= static_cast<Scalar>(other * inverse_n);
        if (every > 0.0) gradient.col(j).array() -= static_cast<Scalar>(every * inverse_n);
    }
    return loss * inverse_n;
}

}  // namespace specula
