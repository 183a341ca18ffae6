#include "classifier/unrolled.hpp"

#include "sim/core/expect.hpp"

namespace specula {

namespace {

std::vector<float> repeated(const std::vector<float>& per_channel, std::size_t n_positions) {
    std::vector<float> all;
    for (std::size_t p = 0; p < n_positions; ++p)
        all.insert(all.end(), per_channel.begin(), per_channel.end());
    return all;
}

std::vector<float> spread_weights(const HiddenLayer& layer) {
    const std::size_t n = layer.convolution->n_positions;
    const std::size_t kernel = layer.convolution->kernel;
    const std::size_t n_from = layer.n_in / n, n_to = layer.n_out / n;
    SPECULA_EXPECT(layer.weight.size() == n_to * kernel * n_from);
    std::vector<float> weight(layer.n_in * layer.n_out, 0.0f);
    for (std::size_t to = 0; to < n; ++to)
        for (std::size_t k = 0; k < kernel; ++k) {
            const std::size_t shifted = to + k;  // of the position seen, plus half a kernel
            if (shifted < kernel / 2 || shifted - kernel / 2 >= n) continue;
            const std::size_t from = shifted - kernel / 2;
            for (std::size_t o = 0; o < n_to; ++o)
                for (std::size_t i = 0; i < n_from; ++i)
                    weight[(to * n_to + o) * layer.n_in + from * n_from + i] =
                        layer.weight[(o * kernel + k) * n_from + i];
        }
    return weight;
}

}  // namespace

HiddenLayer unrolled(const HiddenLayer& layer) {
    if (!layer.convolution) return layer;
    const std::size_t n = layer.convolution->n_positions;
    HiddenLayer plain = layer;
    plain.convolution.reset();
    plain.weight = spread_weights(layer);
    for (std::vector<float>* values :
         {&plain.gamma, &plain.beta, &plain.mean, &plain.variance, &plain.bias})
        *values = repeated(*values, n);
    if (plain.after_relu)
        for (std::vector<float>* values : {&plain.after_relu->gamma, &plain.after_relu->beta,
                                           &plain.after_relu->mean, &plain.after_relu->variance})
            *values = repeated(*values, n);
    return plain;
}

Model unrolled(const Model& model) {
    Model plain = model;
    for (HiddenLayer& layer : plain.hidden) layer = unrolled(layer);
    return plain;
}

ModelCost cost_of(const Model& model) {
    ModelCost cost;
    const std::size_t output = model.output.n_in * model.output.n_out;
    for (const HiddenLayer& layer : model.hidden) {
        const std::size_t n = layer.convolution ? layer.convolution->n_positions : 1;
        cost.multiply_accumulates += layer.weight.size() * n;
        cost.parameters += layer.weight.size() + layer.n_out / n;
        cost.unrolled_multiply_accumulates += layer.n_in * layer.n_out;
        cost.unrolled_parameters += (layer.n_in + 1) * layer.n_out;
    }
    cost.multiply_accumulates += output;
    cost.unrolled_multiply_accumulates += output;
    cost.parameters += output + model.output.n_out;
    cost.unrolled_parameters += output + model.output.n_out;
    return cost;
}

}  // namespace specula
