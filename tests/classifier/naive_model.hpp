#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "classifier/model.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// A model with every number drawn, for tests of what carries models.
inline Model random_model(const std::vector<std::size_t>& widths) {
    Stream stream({.seed = 21, .purpose = "random model"});
    const auto around = [&](double centre, std::size_t n) {
        std::vector<float> values(n);
        for (float& value : values) value = static_cast<float>(centre + 0.4 * stream.normal());
        return values;
    };
    const auto positive = [&](std::size_t n) {
        std::vector<float> values(n);
        for (float& value : values) value = static_cast<float>(0.1 + 2.0 * stream.uniform());
        return values;
    };
    Model model;
    model.extractor = "random";
    model.input_mean = around(0.0, widths.front());
    model.input_scale = positive(widths.front());
    for (std::size_t l = 0; l + 2 < widths.size(); ++l)
        model.hidden.push_back({.n_in = widths[l],
                                .n_out = widths[l + 1],
                                .weight = around(0.0, widths[l] * widths[l + 1]),
                                .gamma = around(1.0, widths[l + 1]),
                                .beta = around(0.0, widths[l + 1]),
                                .mean = around(0.0, widths[l + 1]),
                                .variance = positive(widths[l + 1])});
    const std::size_t n_in = widths[widths.size() - 2];
    model.output = {.n_in = n_in,
                    .n_out = widths.back(),
                    .weight = around(0.0, n_in * widths.back()),
                    .bias = around(0.0, widths.back())};
    for (std::size_t c = 0; c < widths.back(); ++c)
        model.class_names.push_back("class " + std::to_string(c));
    return model;
}

/// Features of an example like those a model expects.
inline std::vector<float> random_features(std::size_t n, Stream& stream) {
    std::vector<float> features(n);
    for (float& feature : features) feature = static_cast<float>(2.0 * stream.normal());
    return features;
}

/// weight x + bias by two plain loops, in double.
template <typename Scalar>
std::vector<double> affine(const std::vector<Scalar>& weight, const std::vector<Scalar>& bias,
                           const std::vector<double>& x) {
    std::vector<double> y(bias.begin(), bias.end());
    for (std::size_t o = 0; o < y.size(); ++o)
        for (std::size_t i = 0; i < x.size(); ++i)
            y[o] += static_cast<double>(weight[o * x.size() + i]) * x[i];
    return y;
}

inline std::vector<double> standardised(const Model& model, std::span<const float> features) {
    std::vector<double> x(features.begin(), features.end());
    for (std::size_t f = 0; f < x.size(); ++f)
        x[f] = (x[f] - static_cast<double>(model.input_mean[f])) *
               static_cast<double>(model.input_scale[f]);
    return x;
}

/// The model as its docstring has it, nothing folded, in double.
inline std::vector<double> naive_logits(const Model& model, std::span<const float> features) {
    std::vector<double> x = standardised(model, features);
    for (const HiddenLayer& layer : model.hidden) {
        x = affine(layer.weight, std::vector<float>(layer.n_out, 0.0f), x);
        for (std::size_t o = 0; o < x.size(); ++o) {
            const double normalised = (x[o] - static_cast<double>(layer.mean[o])) /
                                      std::sqrt(static_cast<double>(layer.variance[o]) + 1e-5);
            x[o] = std::max(0.0, static_cast<double>(layer.gamma[o]) * normalised +
                                     static_cast<double>(layer.beta[o]));
        }
    }
    return affine(model.output.weight, model.output.bias, x);
}

}  // namespace specula
