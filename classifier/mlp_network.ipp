#pragma once

/// Definitions of mlp_network.hpp: included where a scalar type is instantiated, nowhere else.
#include "classifier/mlp_network.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/convolution_patches.hpp"
#include "classifier/network_loss.hpp"
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

/// Rows and columns as a layer takes them from contiguous storage.
template <typename Scalar>
Eigen::Map<const Matrix<Scalar>> seen_as(const Matrix<Scalar>& storage, Eigen::Index n_rows,
                                         Eigen::Index n_columns) {
    return {storage.data(), n_rows, n_columns};
}

/// What the weights of layer l are multiplied with: the values below it, or patches of them.
template <typename Scalar>
Eigen::Map<const Matrix<Scalar>> layer_input(const MlpNetwork<Scalar>& network,
                                             const MlpWorkspace<Scalar>& w, std::size_t l) {
    const Matrix<Scalar>& storage = l < network.convolution.size() ? w.patches[l]
                                    : l > 0                        ? w.hidden[l - 1].output
                                                                   : w.input;
    return seen_as(storage, network.layers[l].weight.cols(), w.n_examples * network.n_positions(l));
}

template <typename Scalar>
void gather_input(const MlpNetwork<Scalar>& network, std::size_t l, MlpWorkspace<Scalar>& w) {
    const Matrix<Scalar>& below = l > 0 ? w.hidden[l - 1].output : w.input;
    const Convolution& convolution = network.convolution[l];
    const auto n_channels =
        network.layers[l].weight.cols() / static_cast<Eigen::Index>(convolution.kernel);
    gather_patches(convolution, seen_as(below, n_channels * network.n_positions(l), w.n_examples),
                   w.patches[l]);
}

/// d loss / d (values below layer l) from `d`, d loss / d (sums of layer l).
template <typename Scalar, typename Gradient>
void gradient_below(const MlpNetwork<Scalar>& network, std::size_t l, const Gradient& d,
                    MlpWorkspace<Scalar>& w) {
    const Matrix<Scalar>& weight = network.layers[l].weight;
    Scalar* const below = w.hidden[l - 1].gradient.data();
    if (l >= network.convolution.size()) {
        Eigen::Map<Matrix<Scalar>> rows(below, weight.cols(), w.n_examples);
        rows.noalias() = weight.transpose() * d;
        return;
    }
    const Convolution& convolution = network.convolution[l];
    const auto n_channels = weight.cols() / static_cast<Eigen::Index>(convolution.kernel);
    Eigen::Map<Matrix<Scalar>> rows(below, n_channels * network.n_positions(l), w.n_examples);
    auto patches = w.patch_gradient[l].leftCols(d.cols());
    patches.noalias() = weight.transpose() * d;
    scatter_patches(convolution, patches, rows);
}

}  // namespace

template <typename Scalar>
MlpNetwork<Scalar> initial_network(const std::vector<int>& widths, Stream& stream) {
    SPECULA_EXPECT(widths.size() >= 2);
    return initial_network<Scalar>({.n_features = widths.front(),
                                    .channels = {},
                                    .hidden = {widths.begin() + 1, widths.end() - 1},
                                    .n_classes = widths.back()},
                                   stream);
}

template <typename Scalar>
MlpNetwork<Scalar> initial_network(const NetworkShape& shape, Stream& stream) {
    SPECULA_EXPECT(shape.n_features > 0 && shape.n_classes > 0 && shape.kernel % 2 == 1);
    MlpNetwork<Scalar> network;
    const auto uniform_within = [&stream](double bound) {
        return [&stream, bound] {
            return static_cast<Scalar>(bound * (2.0 * stream.uniform() - 1.0));
        };
    };
    const auto add = [&](int n_in, int n_out) {
        SPECULA_EXPECT(n_out > 0);
        const auto draw = uniform_within(1.0 / std::sqrt(static_cast<double>(n_in)));
        network.layers.push_back({.weight = Matrix<Scalar>::NullaryExpr(n_out, n_in, draw),
                                  .bias = {},
                                  .gamma = {},
                                  .beta = {}});
    };
    const auto normalise = [&](int n_out) {
        network.layers.back().gamma.setOnes(n_out);
        network.layers.back().beta.setZero(n_out);
        network.running.push_back({.mean = ColumnVector<Scalar>::Zero(n_out),
                                   .variance = ColumnVector<Scalar>::Ones(n_out)});
    };
    int n_channels = 1;
    for (const int channels : shape.channels) {
        add(shape.kernel * n_channels, channels);
        normalise(channels);
        network.convolution.push_back({.n_positions = static_cast<std::size_t>(shape.n_features),
                                       .kernel = static_cast<std::size_t>(shape.kernel)});
        n_channels = channels;
    }
    int n_in = shape.n_features * n_channels;
    for (const int units : shape.hidden) {
        add(n_in, units);
        normalise(units);
        n_in = units;
    }
    add(n_in, shape.n_classes);
    network.layers.back().bias = ColumnVector<Scalar>::NullaryExpr(
        shape.n_classes, uniform_within(1.0 / std::sqrt(static_cast<double>(n_in))));
    return network;
}

template <typename Scalar>
MlpWorkspace<Scalar>::MlpWorkspace(const MlpNetwork<Scalar>& network, Eigen::Index max_examples)
    : input(network.convolution.empty() ? network.layers.front().weight.cols()
                                        : network.n_positions(0),
            max_examples),
      label(static_cast<std::size_t>(max_examples)),
      logits(network.layers.back().weight.rows(), max_examples),
      logit_gradient(logits),
      gradient(network.layers) {
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const Eigen::Index n_columns = max_examples * network.n_positions(l);
        if (l < network.convolution.size())
            patches.emplace_back(network.layers[l].weight.cols(), n_columns);
        const Matrix<Scalar> buffer(network.layers[l].weight.rows(), n_columns);
        const ColumnVector<Scalar> per_unit(buffer.rows());
        hidden.push_back(
            {buffer, buffer, buffer, per_unit, per_unit, per_unit, per_unit, per_unit, per_unit});
    }
    patch_gradient = patches;
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
    workspace.own_share = 1.0;
}

template <typename Scalar>
void load_mixed_batch(const Matrix<Scalar>& inputs, std::span<const std::uint8_t> labels,
                      const MixedRows& rows, MlpWorkspace<Scalar>& workspace) {
    SPECULA_EXPECT(rows.other.size() == rows.chosen.size());
    load_batch(inputs, labels, rows.chosen, workspace);
    workspace.own_share = rows.share;
    workspace.other_label.resize(rows.other.size());
    const auto own = static_cast<Scalar>(rows.share);
    const auto other = static_cast<Scalar>(1.0 - rows.share);
    for (std::size_t j = 0; j < rows.other.size(); ++j) {
        auto column = workspace.input.col(static_cast<Eigen::Index>(j));
        column = own * column + other * inputs.col(rows.other[j]);
        workspace.other_label[j] = labels[rows.other[j]];
    }
}

template <typename Scalar>
double forward_train(MlpNetwork<Scalar>& network, MlpWorkspace<Scalar>& w) {
    SPECULA_EXPECT(w.n_examples >= 2);
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const MlpLayer<Scalar>& layer = network.layers[l];
        if (l < network.convolution.size()) gather_input(network, l, w);
        const auto in = layer_input(network, w, l);
        auto sums = w.hidden[l].normalised.leftCols(in.cols());
        sums.noalias() = layer.weight * in;
        if (layer.bias.size() > 0) sums.colwise() += layer.bias;
        normalise_and_rectify(layer, network.running[l], in.cols(), w.hidden[l]);
    }
    auto logits = w.logits.leftCols(w.n_examples);
    logits.noalias() = network.layers.back().weight * layer_input(network, w, network.n_hidden());
    logits.colwise() += network.layers.back().bias;
    return cross_entropy(w);
}

template <typename Scalar>
void backward(const MlpNetwork<Scalar>& network, MlpWorkspace<Scalar>& w) {
    const Matrix<Scalar>* gradient_of_sums = &w.logit_gradient;
    for (std::size_t l = network.layers.size(); l-- > 0;) {
        const auto in = layer_input(network, w, l);
        const auto d = gradient_of_sums->leftCols(in.cols());
        MlpLayer<Scalar>& gradient = w.gradient[l];
        gradient.weight.noalias() = d * in.transpose();
        if (gradient.bias.size() > 0) gradient.bias = d.rowwise().sum();
        if (l == 0) break;
        gradient_below(network, l, d, w);
        through_normalisation(network.layers[l - 1], w.n_examples * network.n_positions(l - 1),
                              w.hidden[l - 1], w.gradient[l - 1]);
        gradient_of_sums = &w.hidden[l - 1].gradient;
    }
}

template <typename Scalar>
Matrix<Scalar> eval_logits(const MlpNetwork<Scalar>& network, const Matrix<Scalar>& inputs) {
    Matrix<Scalar> x = inputs;
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const MlpLayer<Scalar>& layer = network.layers[l];
        const RunningStatistics<Scalar>& running = network.running[l];
        const bool convolves = l < network.convolution.size();
        if (convolves) {
            Matrix<Scalar> patches(layer.weight.cols(), inputs.cols() * network.n_positions(l));
            gather_patches(network.convolution[l], x, patches);
            x.swap(patches);
        }
        Matrix<Scalar> sums = layer.weight * x;
        if (layer.bias.size() > 0) sums.colwise() += layer.bias;
        const ColumnVector<Scalar> slope =
            layer.gamma.array() /
            (running.variance.array() + static_cast<Scalar>(batch_norm_epsilon)).sqrt();
        sums.colwise() -= running.mean;
        x = ((sums.array().colwise() * slope.array()).colwise() + layer.beta.array())
                .max(Scalar(0));
        if (convolves) x.resize(x.size() / inputs.cols(), inputs.cols());  // moves no value
    }
    return (network.layers.back().weight * x).colwise() + network.layers.back().bias;
}

}  // namespace specula
