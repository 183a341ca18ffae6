#include "classifier/integer_model.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/unrolled.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr double reach_in_sigma = 6.0;
constexpr double sum_limit = 2147483647.0;

double largest_of(fw_int_width width) {
    return width == FW_INT8 ? 127.0 : 32767.0;
}

/// What comes into a layer: its largest value, and that in steps.
struct Incoming {
    double reach = reach_in_sigma;
    double levels = 127.0;
    double step() const { return reach / levels; }
};

double largest_row_reach(const AffineLayer<double>& layer, double reach) {
    double largest = 0.0;
    for (std::size_t o = 0; o < layer.n_out; ++o) {
        double sum = layer.bias[o];
        for (std::size_t i = 0; i < layer.n_in; ++i)
            sum += std::abs(layer.weight[o * layer.n_in + i]) * reach;
        largest = std::max(largest, sum);
    }
    return largest;
}

/// The largest value behind the ReLU of a hidden layer; positive.
double reach_of(const HiddenLayer& hidden, const AffineLayer<double>& layer,
                const Incoming& incoming) {
    double largest = 0.0;
    for (std::size_t o = 0; o < hidden.gamma.size(); ++o)
        largest =
            std::max(largest, static_cast<double>(hidden.beta[o]) +
                                  reach_in_sigma * std::abs(static_cast<double>(hidden.gamma[o])));
    const double possible = largest_row_reach(layer, incoming.reach);
    if (hidden.gamma.empty() || possible < largest) largest = possible;
    return largest > 0.0 ? largest : 1.0;
}

/// The step of one row of weights: the finest that neither the weights' own width nor the sum's 32
/// bits forbid. Rounding adds half a step to every weight and to the bias.
double weight_step(const AffineLayer<double>& layer, std::size_t o, const Incoming& incoming,
                   fw_int_width width) {
    double largest = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < layer.n_in; ++i) {
        const double size = std::abs(layer.weight[o * layer.n_in + i]);
        largest = std::max(largest, size);
        sum += size;
    }
    const double room = sum_limit - 1.0 - 0.5 * incoming.levels * static_cast<double>(layer.n_in);
    SPECULA_EXPECT(room > 0.0);
    const double needed =
        (incoming.levels * sum + std::abs(layer.bias[o]) / incoming.step()) / room;
    const double step = std::max(largest / largest_of(width), needed);
    return step > 0.0 ? step : 1.0;
}

/// The firmware divides sums by more than 4: what a layer's outgoing values must reach for that.
double smallest_reach(const AffineLayer<double>& layer, const Incoming& incoming,
                      fw_int_width width) {
    constexpr double largest_factor = 0.2499;
    double widest = 0.0;
    for (std::size_t o = 0; o < layer.n_out; ++o)
        widest = std::max(widest, weight_step(layer, o, incoming, width));
    return widest * incoming.step() * incoming.levels / largest_factor;
}

/// factor = multiplier / 2^shift, the multiplier having 31 bits where the shift allows it.
void set_factor(double factor, IntegerLayer& layer) {
    int exponent = 0;
    std::frexp(factor, &exponent);  // factor = m 2^exponent, m in [1/2, 1)
    const int shift = std::clamp(31 - exponent, 33, 62);
    const double multiplier = std::min(std::round(std::ldexp(factor, shift)), sum_limit);
    layer.multiplier.push_back(static_cast<std::int32_t>(multiplier));
    layer.shift.push_back(shift);
}

IntegerLayer quantise_layer(const AffineLayer<double>& layer, const Incoming& incoming,
                            const Incoming* outgoing, fw_int_width width) {
    const std::size_t stride = fw_int_stride(width, static_cast<std::uint16_t>(layer.n_in));
    IntegerLayer result{.n_in = layer.n_in,
                        .n_out = layer.n_out,
                        .bytes = {},
                        .halves = {},
                        .bias = {},
                        .multiplier = {},
                        .shift = {},
                        .scale = {}};
    (width == FW_INT8 ? result.bytes.resize(stride * layer.n_out)
                      : result.halves.resize(stride * layer.n_out));
    for (std::size_t o = 0; o < layer.n_out; ++o) {
        const double step = weight_step(layer, o, incoming, width);
        for (std::size_t i = 0; i < layer.n_in; ++i) {
            const double level = std::round(layer.weight[o * layer.n_in + i] / step);
            if (width == FW_INT8) result.bytes[o * stride + i] = static_cast<std::int8_t>(level);
            if (width == FW_INT16) result.halves[o * stride + i] = static_cast<std::int16_t>(level);
        }
        const double sum_step = step * incoming.step();
        result.bias.push_back(static_cast<std::int32_t>(std::round(layer.bias[o] / sum_step)));
        if (outgoing) set_factor(sum_step / outgoing->step(), result);
        if (!outgoing) result.scale.push_back(static_cast<float>(sum_step));
    }
    return result;
}

}  // namespace

IntegerModel quantise(const Model& trained, fw_int_width width) {
    const Model model = unrolled(trained);
    const FoldedModel folded = fold(model);
    const std::vector<AffineLayer<double>> layers = folded_layers(model);
    Incoming incoming{.reach = reach_in_sigma, .levels = largest_of(width)};
    IntegerModel result{.width = width,
                        .input_mean = folded.input_mean,
                        .input_scale = folded.input_scale,
                        .input_levels = static_cast<float>(1.0 / incoming.step()),
                        .layers = {}};
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const bool is_last = l + 1 == layers.size();
        Incoming outgoing = incoming;
        if (!is_last)
            outgoing.reach = std::max(reach_of(model.hidden[l], layers[l], incoming),
                                      smallest_reach(layers[l], incoming, width));
        result.layers.push_back(
            quantise_layer(layers[l], incoming, is_last ? nullptr : &outgoing, width));
        incoming = outgoing;
    }
    return result;
}

fw_int_mlp IntegerModel::view() const& {
    SPECULA_EXPECT(!layers.empty() && layers.size() <= FW_MLP_MAX_LAYERS);
    fw_int_mlp mlp{};
    mlp.width = width;
    mlp.n_layers = static_cast<std::uint16_t>(layers.size());
    mlp.input_mean = input_mean.data();
    mlp.input_scale = input_scale.data();
    mlp.input_levels = input_levels;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const IntegerLayer& layer = layers[l];
        mlp.layer[l] = {.n_in = static_cast<std::uint16_t>(layer.n_in),
                        .n_out = static_cast<std::uint16_t>(layer.n_out),
                        .weight = width == FW_INT8 ? static_cast<const void*>(layer.bytes.data())
                                                   : static_cast<const void*>(layer.halves.data()),
                        .bias = layer.bias.data(),
                        .multiplier = layer.multiplier.data(),
                        .shift = layer.shift.data(),
                        .scale = layer.scale.data()};
    }
    return mlp;
}

}  // namespace specula
