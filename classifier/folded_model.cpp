#include "classifier/folded_model.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "classifier/unrolled.hpp"
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

/// A batch normalisation as x -> factor x + offset.
struct Slope {
    std::vector<double> factor;
    std::vector<double> offset;
};

Slope slope_of(const BatchNorm& norm) {
    Slope slope;
    for (std::size_t i = 0; i < norm.gamma.size(); ++i) {
        const double factor = static_cast<double>(norm.gamma[i]) /
                              std::sqrt(static_cast<double>(norm.variance[i]) + batch_norm_epsilon);
        slope.factor.push_back(factor);
        slope.offset.push_back(static_cast<double>(norm.beta[i]) -
                               factor * static_cast<double>(norm.mean[i]));
    }
    return slope;
}

/// Lets a layer take over the normalisation of what comes into it.
void fold_forward(const BatchNorm& norm, AffineLayer<double>& layer) {
    SPECULA_EXPECT(norm.gamma.size() == layer.n_in);
    const Slope slope = slope_of(norm);
    for (std::size_t o = 0; o < layer.n_out; ++o)
        for (std::size_t i = 0; i < layer.n_in; ++i) {
            double& weight = layer.weight[o * layer.n_in + i];
            layer.bias[o] += weight * slope.offset[i];
            weight *= slope.factor[i];
        }
}

}  // namespace

AffineLayer<double> folded(const HiddenLayer& hidden) {
    const HiddenLayer layer = unrolled(hidden);
    AffineLayer<double> result{.n_in = layer.n_in,
                               .n_out = layer.n_out,
                               .weight = {layer.weight.begin(), layer.weight.end()},
                               .bias = {layer.bias.begin(), layer.bias.end()}};
    result.bias.resize(layer.n_out);
    if (layer.gamma.empty()) return result;
    const Slope slope = slope_of({layer.gamma, layer.beta, layer.mean, layer.variance});
    for (std::size_t o = 0; o < layer.n_out; ++o) {
        for (std::size_t i = o * layer.n_in; i < (o + 1) * layer.n_in; ++i)
            result.weight[i] *= slope.factor[o];
        result.bias[o] = slope.factor[o] * result.bias[o] + slope.offset[o];
    }
    return result;
}

std::vector<AffineLayer<double>> folded_layers(const Model& model) {
    std::vector<AffineLayer<double>> layers;
    std::optional<BatchNorm> ahead = model.input_norm;
    for (const HiddenLayer& layer : model.hidden) {
        layers.push_back(folded(layer));
        if (ahead) fold_forward(*ahead, layers.back());
        ahead = unrolled(layer).after_relu;
    }
    layers.push_back({.n_in = model.output.n_in,
                      .n_out = model.output.n_out,
                      .weight = {model.output.weight.begin(), model.output.weight.end()},
                      .bias = {model.output.bias.begin(), model.output.bias.end()}});
    if (ahead) fold_forward(*ahead, layers.back());
    return layers;
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
    for (const AffineLayer<double>& layer : folded_layers(model))
        result.layers.push_back(rounded(layer));
    return result;
}

}  // namespace specula
