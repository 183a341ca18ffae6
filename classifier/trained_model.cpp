#include "classifier/trained_model.hpp"

namespace specula {

namespace {

template <typename Scalar>
std::vector<float> values(const ColumnVector<Scalar>& vector) {
    const ColumnVector<float> rounded = vector.template cast<float>();
    return {rounded.begin(), rounded.end()};
}

/// (out, in), row-major.
template <typename Scalar>
std::vector<float> values(const Matrix<Scalar>& matrix) {
    const Matrix<float> transposed = matrix.transpose().template cast<float>();
    return {transposed.data(), transposed.data() + transposed.size()};
}

}  // namespace

template <typename Scalar>
Model model_of(const MlpNetwork<Scalar>& network) {
    Model model;
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const MlpLayer<Scalar>& layer = network.layers[l];
        const auto n_units = static_cast<std::size_t>(layer.weight.rows());
        const auto n_columns = static_cast<std::size_t>(layer.weight.cols());
        model.hidden.push_back({.n_in = n_columns,
                                .n_out = n_units,
                                .weight = values(layer.weight),
                                .gamma = values(layer.gamma),
                                .beta = values(layer.beta),
                                .mean = values(network.running[l].mean),
                                .variance = values(network.running[l].variance),
                                .bias = values(layer.bias)});
        if (l >= network.convolution.size()) continue;
        const Convolution& convolution = network.convolution[l];
        HiddenLayer& hidden = model.hidden.back();
        hidden.convolution = convolution;
        hidden.n_in = n_columns / convolution.kernel * convolution.n_positions;
        hidden.n_out = n_units * convolution.n_positions;
    }
    const MlpLayer<Scalar>& output = network.layers.back();
    model.output = {.n_in = static_cast<std::size_t>(output.weight.cols()),
                    .n_out = static_cast<std::size_t>(output.weight.rows()),
                    .weight = values(output.weight),
                    .bias = values(output.bias)};
    return model;
}

template <typename Scalar>
bool is_finite(const MlpNetwork<Scalar>& network) {
    bool finite = true;
    for (const MlpLayer<Scalar>& layer : network.layers)
        finite = finite && layer.weight.allFinite() && layer.bias.allFinite() &&
                 layer.gamma.allFinite() && layer.beta.allFinite();
    for (const RunningStatistics<Scalar>& running : network.running)
        finite = finite && running.mean.allFinite() && running.variance.allFinite();
    return finite;
}

template Model model_of(const MlpNetwork<float>&);
template Model model_of(const MlpNetwork<double>&);
template bool is_finite(const MlpNetwork<float>&);
template bool is_finite(const MlpNetwork<double>&);

}  // namespace specula
