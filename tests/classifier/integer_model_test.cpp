#include "classifier/integer_model.hpp"

#include <algorithm>
#include <cmath>

#include "tests/check.hpp"
#include "tests/classifier/naive_model.hpp"

namespace specula {
namespace {

/// The largest difference of logits between the integer network and the unfolded one in double,
/// over inputs like those standardisation gives, as a share of the logits' spread.
double relative_error(const Model& model, fw_int_width width) {
    const IntegerModel integers = quantise(model, width);
    const fw_int_mlp view = integers.view();
    for (std::size_t l = 0; l < integers.layers.size(); ++l)
        REQUIRE(fw_int_layer_check(&view.layer[l], width, l + 1 == integers.layers.size()) ==
                FW_OK);
    std::vector<float> scratch(fw_int_mlp_scratch(&view) / 4), logits(model.n_classes());
    Stream stream({.seed = 9, .purpose = "integer test"});
    double squares = 0.0, errors = 0.0;
    for (int i = 0; i < 200; ++i) {
        const auto features = random_features(model.n_features(), stream);
        REQUIRE(fw_int_mlp_run(&view, features.data(), scratch.data(), 4 * scratch.size(),
                               logits.data(), nullptr) == FW_OK);
        const auto expected = naive_logits(model, features);
        for (std::size_t c = 0; c < logits.size(); ++c) {
            squares += expected[c] * expected[c];
            errors += std::pow(static_cast<double>(logits[c]) - expected[c], 2);
        }
    }
    return std::sqrt(errors / squares);
}

/// Gives every normalisation the mean and variance of what really comes into it, as training does.
void settle(Model& model) {
    for (std::size_t l = 0; l < model.hidden.size(); ++l) {
        HiddenLayer& layer = model.hidden[l];
        Model up_to = model;  // ends in this layer's linear part
        up_to.hidden.resize(l);
        up_to.output = {.n_in = layer.n_in,
                        .n_out = layer.n_out,
                        .weight = layer.weight,
                        .bias = std::vector<float>(layer.n_out, 0.0f)};
        Stream stream({.seed = 10, .purpose = "settle"});
        std::vector<double> sum(layer.n_out), square(layer.n_out);
        constexpr int n = 500;
        for (int i = 0; i < n; ++i) {
            const auto x = naive_logits(up_to, random_features(model.n_features(), stream));
            for (std::size_t o = 0; o < x.size(); ++o) sum[o] += x[o] / n;
            for (std::size_t o = 0; o < x.size(); ++o) square[o] += x[o] * x[o] / n;
        }
        for (std::size_t o = 0; o < layer.n_out; ++o) {
            layer.mean[o] = static_cast<float>(sum[o]);
            layer.variance[o] = static_cast<float>(square[o] - sum[o] * sum[o]);
        }
    }
}

TEST_CASE("integers follow the unfolded network in double as closely as their steps allow",
          "[integer]") {
    Model model = random_model({12, 16, 16, 5});
    model.input_mean.assign(12, 0.0f);
    model.input_scale.assign(12, 0.5f);  // features of spread 2: standardised
    settle(model);
    // An input of spread 1 in steps of 6/127 (6/32767) carries a rounding error of 1.4 % (5e-5),
    // and two more layers add as much each.
    CHECK(relative_error(model, FW_INT8) < 0.05);
    CHECK(relative_error(model, FW_INT8) > 0.001);
    CHECK(relative_error(model, FW_INT16) < 2e-4);
}

TEST_CASE("wide layers, zero rows and huge biases are quantised without overflow", "[integer]") {
    Model model = random_model({12, 300, 8, 3});
    std::fill(model.hidden[1].weight.begin(), model.hidden[1].weight.begin() + 300, 0.0f);
    model.output.bias = {1e6f, -1e6f, 0.0f};
    for (const auto width : {FW_INT8, FW_INT16}) {
        const IntegerModel integers = quantise(model, width);
        const fw_int_mlp view = integers.view();
        for (std::size_t l = 0; l < 3; ++l)
            CHECK(fw_int_layer_check(&view.layer[l], width, l == 2) == FW_OK);
    }
}

}  // namespace
}  // namespace specula
