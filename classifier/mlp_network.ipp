#pragma once

/// Definitions of mlp_network.hpp: included where a scalar type is instantiated, nowhere else.
#include "classifier/mlp_network.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/model.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr double running_momentum = 0.1;

/// Turns `x` (unit, example), the sums before normalisation, into the hidden layer's output.
template <typename Scalar>
void normalise_and_rectify(const MlpLayer<Scalar>& layer, RunningStatistics<Scalar>& running,
                           Eigen::Index n_examples, typename MlpWorkspace<Scalar>::Hidden& hidden) {
    const auto n = static_cast<Scalar>(n_examples);
    auto x = hidden.normalised.leftCols(n_examples);
    hidden.mean = x.rowwise().sum() / n;
    x.colwise() -= hidden.mean;
    hidden.variance = x.array().square().rowwise().sum() / n;
    hidden.inverse_sd =
        (hidden.variance.array() + static_cast<Scalar>(batch_norm_epsilon)).sqrt().inverse();
    x.array().colwise() *= hidden.inverse_sd.array();
    hidden.output.leftCols(n_examples).array() =
        ((x.array().colwise() * layer.gamma.array()).colwise() + layer.beta.array()).max(Scalar(0));

    const auto kept = static_cast<Scalar>(1.0 - running_momentum);
    const auto taken = static_cast<Scalar>(running_momentum);
    running.mean = kept * running.mean + taken * hidden.mean;
    running.variance = kept * running.variance + (taken * n / (n - 1)) * hidden.variance;
}

/// Turns `hidden.gradient`, d loss / d output, into d loss / d (what enters the normalisation).
template <typename Scalar>
void through_normalisation(const MlpLayer<Scalar>& layer, Eigen::Index n_examples,
                           typename MlpWorkspace<Scalar>::Hidden& hidden,
                           MlpLayer<Scalar>& gradient) {
    auto x = hidden.normalised.leftCols(n_examples);
    auto d = hidden.gradient.leftCols(n_examples);
    for (Eigen::Index k = 0; k < d.size(); ++k)  // both contiguous: all rows of the first columns
        d.data()[k] = hidden.output.data()[k] > 0 ? d.data()[k] : 0;
    gradient.beta = d.rowwise().sum();
    gradient.gamma = (d.array() * x.array()).rowwise().sum();
    const auto n = static_cast<Scalar>(n_examples);
    hidden.gradient_mean = gradient.beta / n;
    hidden.gradient_product = gradient.gamma / n;
    hidden.gain = layer.gamma.cwiseProduct(hidden.inverse_sd);
    d.array() = ((d.array().colwise() - hidden.gradient_mean.array()) -
                 x.array().colwise() * hidden.gradient_product.array())
                    .colwise() *
                hidden.gain.array();
}

/// Mean cross-entropy by log-sum-exp; leaves d loss / d logit.
template <typename Scalar>
double cross_entropy(MlpWorkspace<Scalar>& w) {
    auto logits = w.logits.leftCols(w.n_examples);
    auto gradient = w.logit_gradient.leftCols(w.n_examples);
    for (Eigen::Index j = 0; j < w.n_examples; ++j)
        gradient.col(j).array() = logits.col(j).array() - logits.col(j).maxCoeff();
    double loss = 0.0;
    for (Eigen::Index j = 0; j < w.n_examples; ++j) loss -= gradient(w.label[j], j);
    gradient = gradient.array().exp();
    const Scalar inverse_n = Scalar(1) / static_cast<Scalar>(w.n_examples);
    for (Eigen::Index j = 0; j < w.n_examples; ++j) {
        const Scalar sum = gradient.col(j).sum();
        loss += std::log(static_cast<double>(sum));
        gradient.col(j) *= inverse_n / sum;
        gradient(w.label[j], j) -= inverse_n;
    }
    return loss / static_cast<double>(w.n_examples);
}

}  // namespace

template <typename Scalar>
MlpNetwork<Scalar> initial_network(const std::vector<int>& widths, Stream& stream) {
    SPECULA_EXPECT(widths.size() >= 2);
    SPECULA_EXPECT(std::ranges::all_of(widths, [](int width) { return width > 0; }));
    MlpNetwork<Scalar> network;
    for (std::size_t l = 0; l + 1 < widths.size(); ++l) {
        const int n_in = widths[l];
        const int n_out = widths[l + 1];
        const double bound = 1.0 / std::sqrt(static_cast<double>(n_in));
        const auto draw = [&] {
            return static_cast<Scalar>(bound * (2.0 * stream.uniform() - 1.0));
        };
        MlpLayer<Scalar> layer;
        layer.weight = Matrix<Scalar>::NullaryExpr(n_out, n_in, draw);
        if (l + 2 < widths.size()) {
            layer.gamma.setOnes(n_out);
            layer.beta.setZero(n_out);
            network.running.push_back({.mean = ColumnVector<Scalar>::Zero(n_out),
                                       .variance = ColumnVector<Scalar>::Ones(n_out)});
        } else {
            layer.bias = ColumnVector<Scalar>::NullaryExpr(n_out, draw);
        }
        network.layers.push_back(layer);
    }
    return network;
}

template <typename Scalar>
MlpWorkspace<Scalar>::MlpWorkspace(const MlpNetwork<Scalar>& network, Eigen::Index max_examples)
    : input(network.layers.front().weight.cols(), max_examples),
      label(static_cast<std::size_t>(max_examples)),
      logits(network.layers.back().weight.rows(), max_examples),
      logit_gradient(logits),
      gradient(network.layers) {
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const Matrix<Scalar> buffer(network.layers[l].weight.rows(), max_examples);
        const ColumnVector<Scalar> per_unit(buffer.rows());
        hidden.push_back(
            {buffer, buffer, buffer, per_unit, per_unit, per_unit, per_unit, per_unit, per_unit});
    }
}

template <typename Scalar>
void load_batch(const Matrix<Scalar>& inputs, std::span<const std::uint8_t> labels,
                std::span<const std::uint32_t> chosen, MlpWorkspace<Scalar>& workspace) {
    workspace.n_examples = static_cast<Eigen::Index>(chosen.size());
    SPECULA_EXPECT(workspace.n_examples <= workspace.input.cols());
    for (std::size_t j = 0; j < chosen.size(); ++j) {
        workspace.input.col(static_cast<Eigen::Index>(j)) = inputs.col(chosen[j]);
        workspace.label[j] = labels[chosen[j]];
    }
}

template <typename Scalar>
double forward_train(MlpNetwork<Scalar>& network, MlpWorkspace<Scalar>& w) {
    SPECULA_EXPECT(w.n_examples >= 2);
    const Eigen::Index n = w.n_examples;
    const Matrix<Scalar>* in = &w.input;
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const MlpLayer<Scalar>& layer = network.layers[l];
        auto sums = w.hidden[l].normalised.leftCols(n);
        sums.noalias() = layer.weight * in->leftCols(n);
        if (layer.bias.size() > 0) sums.colwise() += layer.bias;
        normalise_and_rectify(layer, network.running[l], n, w.hidden[l]);
        in = &w.hidden[l].output;
    }
    auto logits = w.logits.leftCols(n);
    logits.noalias() = network.layers.back().weight * in->leftCols(n);
    logits.colwise() += network.layers.back().bias;
    return cross_entropy(w);
}

template <typename Scalar>
void backward(const MlpNetwork<Scalar>& network, MlpWorkspace<Scalar>& w) {
    const Eigen::Index n = w.n_examples;
    const Matrix<Scalar>* d = &w.logit_gradient;
    for (std::size_t l = network.layers.size(); l-- > 0;) {
        const Matrix<Scalar>& in = l > 0 ? w.hidden[l - 1].output : w.input;
        MlpLayer<Scalar>& gradient = w.gradient[l];
        gradient.weight.noalias() = d->leftCols(n) * in.leftCols(n).transpose();
        if (gradient.bias.size() > 0) gradient.bias = d->leftCols(n).rowwise().sum();
        if (l == 0) break;
        auto& below = w.hidden[l - 1];
        below.gradient.leftCols(n).noalias() =
            network.layers[l].weight.transpose() * d->leftCols(n);
        through_normalisation(network.layers[l - 1], n, below, w.gradient[l - 1]);
        d = &below.gradient;
    }
}

template <typename Scalar>
Matrix<Scalar> eval_logits(const MlpNetwork<Scalar>& network, const Matrix<Scalar>& inputs) {
    Matrix<Scalar> x = inputs;
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const MlpLayer<Scalar>& layer = network.layers[l];
        const RunningStatistics<Scalar>& running = network.running[l];
        Matrix<Scalar> sums = layer.weight * x;
        if (layer.bias.size() > 0) sums.colwise() += layer.bias;
        const ColumnVector<Scalar> slope =
            layer.gamma.array() /
            (running.variance.array() + static_cast<Scalar>(batch_norm_epsilon)).sqrt();
        sums.colwise() -= running.mean;
        x = ((sums.array().colwise() * slope.array()).colwise() + layer.beta.array())
                .max(Scalar(0));
    }
    return (network.layers.back().weight * x).colwise() + network.layers.back().bias;
}

}  // namespace specula
