#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "classifier/matrix.hpp"
#include "classifier/model.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// What one layer learns, or anything of that shape: its gradient, Adam's moments.
template <typename Scalar>
struct MlpLayer {
    Matrix<Scalar> weight;       ///< (out, in)
    ColumnVector<Scalar> bias;   ///< (out); size 0 in a hidden layer trained without
    ColumnVector<Scalar> gamma;  ///< (out); size 0 in the output layer
    ColumnVector<Scalar> beta;   ///< (out); size 0 in the output layer
};

/// Averages over batches, used instead of a batch's own once training is over.
template <typename Scalar>
struct RunningStatistics {
    ColumnVector<Scalar> mean;      ///< (out)
    ColumnVector<Scalar> variance;  ///< (out)
};

/// Linear - batch normalisation - ReLU, once per hidden layer, then linear. The first hidden layers
/// may be convolutions: their normalisation takes all positions of a channel together.
///
/// In float or double; double so that it can be held against references.
/// @eq  Ioffe and Szegedy 2015, arXiv 1502.03167, algorithm 1; conventions of torch 1.13:
///      batch variance biased, running variance unbiased, running <- 0.9 running + 0.1 batch.
template <typename Scalar>
struct MlpNetwork {
    std::vector<MlpLayer<Scalar>> layers;            ///< hidden ones, then the output
    std::vector<RunningStatistics<Scalar>> running;  ///< (hidden layer)
    std::vector<Convolution> convolution{};          ///< (of the first hidden layers)

    std::size_t n_hidden() const { return running.size(); }
    /// Positions at which a layer's units sit: 1 but for convolutions.
    Eigen::Index n_positions(std::size_t layer) const {
        return layer < convolution.size()
                   ? static_cast<Eigen::Index>(convolution[layer].n_positions)
                   : 1;
    }
};

/// Weights and output bias uniform in +-1/sqrt(n_in); gamma 1, beta 0, running mean 0 and
/// variance 1. Hidden layers get no bias (see classifier/model.hpp).
/// @in  widths  inputs, hidden ..., classes; at least two, each > 0
template <typename Scalar>
MlpNetwork<Scalar> initial_network(const std::vector<int>& widths, Stream& stream);

/// What a network with convolutions is made of.
struct NetworkShape {
    int n_features = 0;         ///< a row of positions of one channel each
    std::vector<int> channels;  ///< of the convolutions; none: initial_network's widths
    int kernel = 3;             ///< odd
    std::vector<int> hidden;    ///< units of the layers behind them
    int n_classes = 0;
};
/// Starts as above, n_in of a convolution being kernel * channels in.
template <typename Scalar>
MlpNetwork<Scalar> initial_network(const NetworkShape& shape, Stream& stream);

/// One batch on its way through a network and back; sized once, so that a step allocates nothing.
template <typename Scalar>
struct MlpWorkspace {
    MlpWorkspace(const MlpNetwork<Scalar>& network, Eigen::Index max_examples);

    /// Of a convolution, an example has one column per position.
    struct Hidden {
        Matrix<Scalar> normalised;  ///< (unit, example), zero mean and unit variance over the batch
        Matrix<Scalar> output;      ///< (unit, example), after the ReLU
        Matrix<Scalar> gradient;    ///< (unit, example), d loss / d (what enters the normalisation)
        ColumnVector<Scalar> mean, variance, inverse_sd;  ///< (unit), of the batch, biased
        ColumnVector<Scalar> gradient_mean, gradient_product, gain;  ///< (unit), on the way back
    };

    Eigen::Index n_examples = 0;
    Matrix<Scalar> input;             ///< (feature, example)
    std::vector<std::uint8_t> label;  ///< (example)

    /// What the loss asks for: (1 - smoothing) on the labels and smoothing over all classes alike.
    double smoothing = 0.0;                 ///< [0, 1)
    double own_share = 1.0;                 ///< of `label`; the rest is the other label's
    std::vector<std::uint8_t> other_label;  ///< (example), of mixed examples

    std::vector<Hidden> hidden;
    std::vector<Matrix<Scalar>> patches;         ///< (convolution): (kernel channel, place)
    std::vector<Matrix<Scalar>> patch_gradient;  ///< as patches
    Matrix<Scalar> logits;                       ///< (class, example)
    Matrix<Scalar> logit_gradient;               ///< (class, example), d loss / d logit
    std::vector<MlpLayer<Scalar>> gradient;      ///< (layer), d loss / d parameter
};

/// Copies columns of `inputs` (feature, example) and their labels into the workspace.
/// @in  chosen  1 to max_examples of them, each < inputs.cols()
template <typename Scalar>
void load_batch(const Matrix<Scalar>& inputs, std::span<const std::uint8_t> labels,
                std::span<const std::uint32_t> chosen, MlpWorkspace<Scalar>& workspace);

/// Rows that are mixed: share * chosen + (1 - share) * other.
struct MixedRows {
    std::span<const std::uint32_t> chosen;
    std::span<const std::uint32_t> other;  ///< as many
    double share = 1.0;                    ///< [0, 1]
};
/// Loads examples between two of `inputs`, with both labels.
/// @eq  Zhang et al. 2018, arXiv 1710.09412, equation (1)
template <typename Scalar>
void load_mixed_batch(const Matrix<Scalar>& inputs, std::span<const std::uint8_t> labels,
                      const MixedRows& rows, MlpWorkspace<Scalar>& workspace);

/// The mean cross-entropy of the loaded batch, in nats. Moves the running statistics on.
/// @in  workspace  at least 2 examples: the variance of one is undefined
template <typename Scalar>
double forward_train(MlpNetwork<Scalar>& network, MlpWorkspace<Scalar>& workspace);

/// Fills `workspace.gradient` for the batch that forward_train saw last.
template <typename Scalar>
void backward(const MlpNetwork<Scalar>& network, MlpWorkspace<Scalar>& workspace);

/// Logits (class, example) with the running statistics, as after training.
/// @in  inputs  (feature, example)
template <typename Scalar>
Matrix<Scalar> eval_logits(const MlpNetwork<Scalar>& network, const Matrix<Scalar>& inputs);

}  // namespace specula
