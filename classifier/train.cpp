#include "classifier/train.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "classifier/adam.hpp"
#include "classifier/input_monitor.hpp"
#include "classifier/mlp_network.hpp"
#include "classifier/standardiser.hpp"
#include "firmware/fw_mlp.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string listed(const std::vector<int>& numbers) {
    std::string text = "[";
    for (const int number : numbers) text += format("{}{}", text.size() > 1 ? ", " : "", number);
    return text + "]";
}

void check(const FeatureTable& rows, const TrainOptions& options) {
    constexpr int max_units = 1024;
    const auto in_range = [](int units) { return units >= 1 && units <= max_units; };
    if (options.hidden.size() + 1 > FW_MLP_MAX_LAYERS)
        throw InputError(format("hidden = {}: too many layers; the firmware runs at most {}",
                                listed(options.hidden), FW_MLP_MAX_LAYERS - 1));
    if (!std::ranges::all_of(options.hidden, in_range))
        throw InputError(format("hidden = {}: a layer is out of range; use 1 to {} units",
                                listed(options.hidden), max_units));
    if (options.epochs < 1)
        throw InputError(format("epochs = {}: too few; use 1 or more", options.epochs));
    if (options.batch_size < 2)
        throw InputError(format("batch_size = {}: too small; use 2 or more", options.batch_size));
    if (!(options.learning_rate > 0.0 && std::isfinite(options.learning_rate)))
        throw InputError(format("learning_rate = {}: is not a positive number; use about 0.001",
                                options.learning_rate));
    if (rows.size() < 2)
        throw InputError(format("training set: has {} rows; at least 2 are needed", rows.size()));
    SPECULA_EXPECT(rows.n_features > 0 && rows.features.size() == rows.size() * rows.n_features);
    SPECULA_EXPECT(*std::ranges::max_element(rows.label) < rows.class_names.size());
}

/// (feature, example), with the float arithmetic of fw_mlp.
Matrix<float> standardised(const FeatureTable& rows, const Standardiser& standardiser) {
    Matrix<float> inputs(static_cast<Eigen::Index>(rows.n_features),
                         static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t f = 0; f < rows.n_features; ++f)
            inputs(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(i)) =
                (rows.row(i)[f] - standardiser.mean[f]) * standardiser.scale[f];
    return inputs;
}

void shuffle(std::vector<std::uint32_t>& order, Stream& stream) {
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[stream.below(static_cast<std::uint32_t>(i))]);
}

/// Trains in place; returns the mean loss of the last epoch.
double fit(const FeatureTable& rows, const Matrix<float>& inputs, const TrainOptions& options,
           Stream& stream, MlpNetwork<float>& network) {
    const std::size_t n = rows.size();
    const auto batch_size = static_cast<std::size_t>(options.batch_size);
    const std::size_t n_batches = std::max<std::size_t>(1, (n + batch_size / 2) / batch_size);
    MlpWorkspace<float> workspace(network,
                                  static_cast<Eigen::Index>((n + n_batches - 1) / n_batches));
    Adam<float> adam(network);
    adam.learning_rate = options.learning_rate;
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    double loss = 0.0;
    for (int epoch = 0; epoch < options.epochs; ++epoch) {
        shuffle(order, stream);
        loss = 0.0;
        for (std::size_t b = 0; b < n_batches; ++b) {
            const std::size_t begin = b * n / n_batches;
            const std::size_t end = (b + 1) * n / n_batches;
            load_batch<float>(inputs, rows.label, std::span(order).subspan(begin, end - begin),
                              workspace);
            loss += forward_train(network, workspace) / static_cast<double>(n_batches);
            backward(network, workspace);
            adam_step(workspace.gradient, adam, network);
        }
    }
    return loss;
}

std::vector<float> values(const ColumnVector<float>& vector) {
    return {vector.begin(), vector.end()};
}

/// (out, in), row-major.
std::vector<float> values(const Matrix<float>& matrix) {
    const Matrix<float> transposed = matrix.transpose();
    return {transposed.data(), transposed.data() + transposed.size()};
}

Model to_model(const MlpNetwork<float>& network) {
    Model model;
    for (std::size_t l = 0; l < network.n_hidden(); ++l) {
        const MlpLayer<float>& layer = network.layers[l];
        model.hidden.push_back({.n_in = static_cast<std::size_t>(layer.weight.cols()),
                                .n_out = static_cast<std::size_t>(layer.weight.rows()),
                                .weight = values(layer.weight),
                                .gamma = values(layer.gamma),
                                .beta = values(layer.beta),
                                .mean = values(network.running[l].mean),
                                .variance = values(network.running[l].variance)});
    }
    const MlpLayer<float>& output = network.layers.back();
    model.output = {.n_in = static_cast<std::size_t>(output.weight.cols()),
                    .n_out = static_cast<std::size_t>(output.weight.rows()),
                    .weight = values(output.weight),
                    .bias = values(output.bias)};
    return model;
}

bool is_finite(const MlpNetwork<float>& network) {
    bool finite = true;
    for (const MlpLayer<float>& layer : network.layers)
        finite = finite && layer.weight.allFinite() && layer.bias.allFinite() &&
                 layer.gamma.allFinite() && layer.beta.allFinite();
    for (const RunningStatistics<float>& running : network.running)
        finite = finite && running.mean.allFinite() && running.variance.allFinite();
    return finite;
}

}  // namespace

Model train(const FeatureTable& rows, const TrainOptions& options, const StreamKey& key) {
    check(rows, options);
    const Standardiser standardiser = fit_standardiser(rows);
    std::vector<int> widths{static_cast<int>(rows.n_features)};
    widths.insert(widths.end(), options.hidden.begin(), options.hidden.end());
    widths.push_back(static_cast<int>(rows.class_names.size()));
    Stream stream(key);
    MlpNetwork<float> network = initial_network<float>(widths, stream);
    const double loss = fit(rows, standardised(rows, standardiser), options, stream, network);
    if (!std::isfinite(loss) || !is_finite(network))
        throw InputError(format("learning_rate = {}: training diverged; use a smaller one",
                                options.learning_rate));
    Model model = to_model(network);
    model.extractor = rows.extractor;
    model.class_names = rows.class_names;
    model.input_mean = standardiser.mean;
    model.input_scale = standardiser.scale;
    model.monitor = fit_input_monitor(rows);
    model.provenance = {{"training rows", format("{}", rows.size())},
                        {"hidden", listed(options.hidden)},
                        {"epochs", format("{}", options.epochs)},
                        {"batch size", format("{}", options.batch_size)},
                        {"learning rate", format("{}", options.learning_rate)},
                        {"stream", format("seed {}, {}, world {}, item {}", key.seed, key.purpose,
                                          key.world, key.item)},
                        {"loss of the last epoch, nats", format("{:.6g}", loss)}};
    return model;
}

}  // namespace specula
