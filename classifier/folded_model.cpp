#include "classifier/folded_model.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

std::uint16_t to_count(std::size_t n) {
    SPECULA_EXPECT(n >= 1 && n <= std::numeric_limits<std::uint16_t>::max());
    return static_cast<std::uint16_t>(n);
}

AffineLayer<float> rounded(const AffineLayer<double>& layer) {
    return {.n_in = layer.n_in,
            .n_out = layer.n_out,
            .weight = {layer.weight.begin(), layer.weight.end()},
            .bias = {layer.bias.begin(), layer.bias.end()}};
}

}  // namespace

AffineLayer<double> folded(const HiddenLayer& layer) {
    AffineLayer<double> result{.n_in = layer.n_in,
                               .n_out = layer.n_out,
                               .weight = std::vector<double>(layer.weight.size()),
                               .bias = std::vector<double>(layer.n_out)};
    for (std::size_t o = 0; o < layer.n_out; ++o) {
        const double slope = static_cast<double>(layer.gamma[o]) /
                             std::sqrt(static_cast<double>(layer.variance[o]) + batch_norm_epsilon);
        for (std::size_t i = o * layer.n_in; i < (o + 1) * layer.n_in; ++i)
            result.weight[i] = slope * static_cast<double>(layer.weight[i]);
        result.bias[o] =
            static_cast<double>(layer.beta[o]) - slope * static_cast<double>(layer.mean[o]);
    }
    return result;
}

fw_mlp FoldedModel::view() const& {
    SPECULA_EXPECT(!layers.empty() && layers.size() <= FW_MLP_MAX_LAYERS);
    fw_mlp mlp{};
    mlp.n_layers = to_count(layers.size());
    mlp.input_mean = input_mean.data();
    mlp.input_scale = input_scale.data();
    for (std::size_t l = 0; l < layers.size(); ++l)
        mlp.layer[l] = {.n_in = to_count(layers[l].n_in),
                        .n_out = to_count(layers[l].n_out),
                        .weight = layers[l].weight.data(),
                        .bias = layers[l].bias.data()};
    return mlp;
}

FoldedModel fold(const Model& model) {
    FoldedModel result{
        .input_mean = model.input_mean, .input_scale = model.input_scale, .layers = {}};
    for (const HiddenLayer& layer : model.hidden) result.layers.push_back(rounded(folded(layer)));
    result.layers.push_back({.n_in = model.output.n_in,
                             .n_out = model.output.n_out,
                             .weight = model.output.weight,
                             .bias = model.output.bias});
    return result;
}

}  // namespace specula
