#include "classifier/folded_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "classifier/predict.hpp"
#include "tests/check.hpp"
#include "tests/classifier/naive_model.hpp"

namespace specula {
namespace {

const std::vector<std::size_t> widths{12, 32, 16, 5};

/// Logits with every hidden layer folded, in double throughout.
std::vector<double> folded_logits(const Model& model, std::span<const float> features) {
    std::vector<double> x = standardised(model, features);
    for (const HiddenLayer& layer : model.hidden) {
        const AffineLayer<double> linear = folded(layer);
        x = affine(linear.weight, linear.bias, x);
        for (double& value : x) value = std::max(0.0, value);
    }
    return affine(model.output.weight, model.output.bias, x);
}

double largest(const std::vector<double>& values) {
    double result = 0.0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

TEST_CASE("folding batch normalisation in double changes rounding only", "[fold]") {
    const Model model = random_model(widths);
    Stream stream({.seed = 1, .purpose = "fold test"});
    double difference = 0.0;
    for (int i = 0; i < 200; ++i) {
        const auto features = random_features(12, stream);
        const auto expected = naive_logits(model, features);
        auto logits = folded_logits(model, features);
        for (std::size_t c = 0; c < logits.size(); ++c) logits[c] -= expected[c];
        difference = std::max(difference, largest(logits) / largest(expected));
    }
    CAPTURE(difference);
    CHECK(difference < 1e-12);
}

TEST_CASE("the firmware's float network answers like the unfolded model in double", "[fold]") {
    const Model model = random_model(widths);
    const FoldedModel for_chip = fold(model);
    FeatureTable row;
    row.n_features = 12;
    row.label = {0};
    Stream stream({.seed = 2, .purpose = "fold test"});
    double difference = 0.0;
    for (int i = 0; i < 200; ++i) {
        row.features = random_features(12, stream);
        const auto expected = naive_logits(model, row.features);
        const Predictions predictions = predict(for_chip, row);
        std::vector<double> logits(predictions.logits.begin(), predictions.logits.end());
        for (std::size_t c = 0; c < logits.size(); ++c) logits[c] -= expected[c];
        difference = std::max(difference, largest(logits) / largest(expected));
    }
    CAPTURE(difference);
    CHECK(difference < 1e-5);
}

TEST_CASE("a view outlives a move of its model", "[fold]") {
    FoldedModel first = fold(random_model(widths));
    const fw_mlp before = first.view();
    std::vector<FoldedModel> moved;
    moved.push_back(std::move(first));
    moved.reserve(100);
    const fw_mlp after = moved.front().view();
    REQUIRE(before.n_layers == 3);
    for (std::size_t l = 0; l < 3; ++l) {
        CHECK(before.layer[l].weight == after.layer[l].weight);
        CHECK(before.layer[l].bias == after.layer[l].bias);
        CHECK(before.layer[l].n_in == widths[l]);
        CHECK(before.layer[l].n_out == widths[l + 1]);
    }
    CHECK(before.input_mean == after.input_mean);
    CHECK(before.input_scale == after.input_scale);
}

template <typename T>
concept lends_a_view = requires(T model) {
    std::forward<T>(model).view();
};

TEST_CASE("a temporary lends no view", "[fold]") {
    STATIC_REQUIRE(lends_a_view<const FoldedModel&>);
    STATIC_REQUIRE_FALSE(lends_a_view<FoldedModel>);
}

}  // namespace
}  // namespace specula
