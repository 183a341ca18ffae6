#include <cmath>

#include "classifier/folded_model.hpp"
#include "classifier/model_file.hpp"
#include "firmware/fw_mlp.h"
#include "tests/check.hpp"
#include "tests/classifier/naive_model.hpp"
#include "tests/classifier/temporary_folder.hpp"

namespace specula {
namespace {

BatchNorm random_norm(std::size_t n, Stream& stream) {
    BatchNorm norm;
    for (std::size_t i = 0; i < n; ++i) {
        norm.gamma.push_back(static_cast<float>(1.0 + 0.3 * stream.normal()));
        norm.beta.push_back(static_cast<float>(0.3 * stream.normal()));
        norm.mean.push_back(static_cast<float>(0.3 * stream.normal()));
        norm.variance.push_back(static_cast<float>(0.2 + 2.0 * stream.uniform()));
    }
    return norm;
}

/// TI's order: normalised inputs, then (linear with bias, ReLU, normalisation) twice, then linear.
Model ti_model() {
    Stream stream({.seed = 3, .purpose = "ti model"});
    Model model = random_model({12, 16, 8, 5});
    model.input_norm = random_norm(12, stream);
    for (HiddenLayer& layer : model.hidden) {
        layer.gamma.clear();
        layer.beta.clear();
        layer.mean.clear();
        layer.variance.clear();
        for (std::size_t o = 0; o < layer.n_out; ++o)
            layer.bias.push_back(static_cast<float>(0.4 * stream.normal()));
        layer.after_relu = random_norm(layer.n_out, stream);
    }
    return model;
}

void apply(const BatchNorm& norm, std::vector<double>& x) {
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = static_cast<double>(norm.gamma[i]) * (x[i] - static_cast<double>(norm.mean[i])) /
                   std::sqrt(static_cast<double>(norm.variance[i]) + 1e-5) +
               static_cast<double>(norm.beta[i]);
}

/// Nothing folded, in double.
std::vector<double> unfolded(const Model& model, std::span<const float> features) {
    std::vector<double> x = standardised(model, features);
    if (model.input_norm) apply(*model.input_norm, x);
    for (const HiddenLayer& layer : model.hidden) {
        x = affine(layer.weight, layer.bias, x);
        for (double& value : x) value = std::max(0.0, value);
        apply(*layer.after_relu, x);
    }
    return affine(model.output.weight, model.output.bias, x);
}

std::vector<double> in_double(const Model& model, std::span<const float> features) {
    std::vector<double> x = standardised(model, features);
    const auto layers = folded_layers(model);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        x = affine(layers[l].weight, layers[l].bias, x);
        if (l + 1 < layers.size())
            for (double& value : x) value = std::max(0.0, value);
    }
    return x;
}

TEST_CASE("normalisation of the inputs and behind a ReLU folds forward without loss", "[fold]") {
    const Model model = ti_model();
    const FoldedModel folded = fold(model);
    const fw_mlp mlp = folded.view();
    std::vector<float> scratch(64), logits(5);
    Stream stream({.seed = 5, .purpose = "fold test"});
    for (int i = 0; i < 50; ++i) {
        const auto features = random_features(12, stream);
        const auto expected = unfolded(model, features);
        const auto doubled = in_double(model, features);
        REQUIRE(fw_mlp_run(&mlp, features.data(), scratch.data(), 256, logits.data(), nullptr) ==
                FW_OK);
        for (std::size_t c = 0; c < 5; ++c) {
            // A few dozen roundings of numbers of about ten: 1e-12 in double, 1e-4 in float.
            CHECK(doubled[c] == Approx(expected[c]).margin(1e-12));
            CHECK(static_cast<double>(logits[c]) == Approx(expected[c]).margin(1e-4));
        }
    }
}

TEST_CASE("a model with every optional part is read back as it was written", "[model]") {
    const TemporaryFolder folder;
    Model model = ti_model();
    model.measurement = Measurement{
        .chirp = {57'500'000, -150'000, 5'000'000, 128, 28, 3, 1, 17'500, -400, 12},
        .descriptor = {6, 12, FW_WINDOW_HANN, FW_INTEGRATE_EXPORTED, FW_RANGE_HWA_LIKE}};
    model.monitor = InputMonitor{.mean = std::vector<float>(12, 1.5f),
                                 .whitening = std::vector<float>(78, 0.25f),
                                 .centre = std::vector<float>(60, -2.0f),
                                 .suspicious_squared = 31.5f};
    write_model(model, folder / "model.json");
    const Model again = read_model(folder / "model.json");
    write_model(again, folder / "again.json");
    Stream stream({.seed = 6, .purpose = "fold test"});
    const auto features = random_features(12, stream);
    CHECK(unfolded(again, features) == unfolded(model, features));
    REQUIRE(again.measurement);
    CHECK(again.measurement->chirp.slope_khz_us == -150'000);
    CHECK(again.measurement->chirp.gain_db_100 == -400);
    CHECK(again.measurement->descriptor.integration == FW_INTEGRATE_EXPORTED);
    CHECK(again.measurement->descriptor.path == FW_RANGE_HWA_LIKE);
    REQUIRE(again.monitor);
    CHECK(again.monitor->whitening == model.monitor->whitening);
    CHECK(again.monitor->suspicious_squared == 31.5f);
}

}  // namespace
}  // namespace specula
