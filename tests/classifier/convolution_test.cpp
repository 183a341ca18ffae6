#include <cmath>
#include <numeric>

#include "classifier/convolution_patches.hpp"
#include "classifier/folded_model.hpp"
#include "classifier/mlp_network.hpp"
#include "classifier/model_file.hpp"
#include "classifier/predict.hpp"
#include "classifier/train.hpp"
#include "classifier/unrolled.hpp"
#include "tests/check.hpp"
#include "tests/classifier/blobs.hpp"
#include "tests/classifier/gradient_check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

const NetworkShape small{
    .n_features = 6, .channels = {3, 4}, .kernel = 3, .hidden = {5}, .n_classes = 3};

/// Nothing at its starting value, and one batch.
struct ConvolvedExample {
    explicit ConvolvedExample(const NetworkShape& shape = small)
        : network(initial_network<double>(shape, stream)),
          inputs(Matrix<double>::NullaryExpr(shape.n_features, 9, [&] { return stream.normal(); })),
          workspace(network, 9) {
        for (auto& layer : network.layers) {
            for (double& gamma : layer.gamma) gamma += 0.3 * stream.normal();
            for (double& beta : layer.beta) beta += 0.3 * stream.normal();
        }
        std::vector<std::uint8_t> labels;
        for (int i = 0; i < 9; ++i) labels.push_back(static_cast<std::uint8_t>(stream.below(3)));
        std::vector<std::uint32_t> all(9);
        std::iota(all.begin(), all.end(), 0u);
        load_batch<double>(inputs, labels, all, workspace);
    }
    double loss() { return forward_train(network, workspace); }

    Stream stream{{.seed = 3, .purpose = "convolution test"}};
    MlpNetwork<double> network;
    Matrix<double> inputs;
    MlpWorkspace<double> workspace;
};

template <typename Array>
double slope_difference(ConvolvedExample& example, Array& parameters, const Array& gradient) {
    constexpr double h = 1e-5;
    double largest = 0.0;
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
        const double kept = parameters.data()[i];
        parameters.data()[i] = kept + h;
        const double above = example.loss();
        parameters.data()[i] = kept - h;
        const double below = example.loss();
        parameters.data()[i] = kept;
        largest = std::max(largest, std::abs((above - below) / (2.0 * h) - gradient.data()[i]));
    }
    return largest;
}

TEST_CASE("gradients of convolutions are the slopes of the loss", "[convolution]") {
    ConvolvedExample example;
    const double smoothing = GENERATE(0.0, 0.15);
    example.workspace.smoothing = smoothing;
    example.loss();
    REQUIRE(distance_from_kinks(example.network, example.workspace) > 1e-4);
    backward(example.network, example.workspace);
    const auto gradient = example.workspace.gradient;
    for (std::size_t l = 0; l < gradient.size(); ++l) {
        CAPTURE(l);
        auto& layer = example.network.layers[l];
        CHECK(slope_difference(example, layer.weight, gradient[l].weight) < 1e-8);
        CHECK(slope_difference(example, layer.bias, gradient[l].bias) < 1e-8);
        CHECK(slope_difference(example, layer.gamma, gradient[l].gamma) < 1e-8);
        CHECK(slope_difference(example, layer.beta, gradient[l].beta) < 1e-8);
    }
}

TEST_CASE("scattering is the transpose of gathering", "[convolution]") {
    // <patches(x), y> = <x, scatter(y)> for any x and y.
    Stream stream({.seed = 5, .purpose = "convolution test"});
    const auto draw_matrix = [&](Eigen::Index rows, Eigen::Index columns) {
        return Matrix<double>(
            Matrix<double>::NullaryExpr(rows, columns, [&] { return stream.normal(); }));
    };
    const Convolution convolution{.n_positions = 7, .kernel = 5};
    const Matrix<double> x = draw_matrix(14, 3), y = draw_matrix(10, 21);
    Matrix<double> patches(10, 21), back(14, 3);
    gather_patches(convolution, x, patches);
    scatter_patches(convolution, y, back);
    CHECK(patches.cwiseProduct(y).sum() == Approx(x.cwiseProduct(back).sum()).epsilon(1e-13));
}

/// A convolution as its definition has it, normalised and rectified, by plain loops.
std::vector<double> plain_convolution(const HiddenLayer& layer, const std::vector<double>& x) {
    const auto n = static_cast<int>(layer.convolution->n_positions);
    const auto kernel = static_cast<int>(layer.convolution->kernel);
    const int n_in = static_cast<int>(x.size()) / n;
    const auto n_out = static_cast<int>(layer.gamma.size());
    std::vector<double> y;
    for (int p = 0; p < n; ++p)
        for (int o = 0; o < n_out; ++o) {
            double sum = 0.0;
            for (int k = 0; k < kernel; ++k)
                for (int i = 0; i < n_in; ++i) {
                    const int seen = p + k - kernel / 2;
                    if (seen < 0 || seen >= n) continue;
                    sum += double(layer.weight[std::size_t((o * kernel + k) * n_in + i)]) *
                           x[std::size_t(seen * n_in + i)];
                }
            const auto u = static_cast<std::size_t>(o);
            sum = (sum - double(layer.mean[u])) / std::sqrt(double(layer.variance[u]) + 1e-5);
            y.push_back(std::max(0.0, double(layer.gamma[u]) * sum + double(layer.beta[u])));
        }
    return y;
}

std::vector<double> plain_logits(const Model& model, std::span<const float> features) {
    std::vector<double> x;
    for (std::size_t f = 0; f < features.size(); ++f)
        x.push_back((double(features[f]) - double(model.input_mean[f])) *
                    double(model.input_scale[f]));
    for (const HiddenLayer& layer : model.hidden) {
        HiddenLayer as_convolution = layer;  // a plain layer is one of a single position
        if (!layer.convolution) as_convolution.convolution = Convolution{};
        if (!layer.convolution) as_convolution.convolution->n_positions = 1;
        x = plain_convolution(as_convolution, x);
    }
    std::vector<double> logits;
    for (std::size_t o = 0; o < model.output.n_out; ++o) {
        logits.push_back(double(model.output.bias[o]));
        for (std::size_t i = 0; i < x.size(); ++i)
            logits.back() += double(model.output.weight[o * x.size() + i]) * x[i];
    }
    return logits;
}

Model trained() {
    return train(draw({.n_rows = 400, .n_features = 6}),
                 {.hidden = {8}, .epochs = 30, .learning_rate = 0.01, .convolution = {4, 5}},
                 {.seed = 5, .purpose = "convolution test"});
}

TEST_CASE("a trained CNN answers on the firmware's network as its definition does",
          "[convolution]") {
    const Model model = trained();
    const FeatureTable asked = draw({.n_features = 6, .item = 1});
    const Predictions answers = predict(fold(model), asked);
    std::size_t n_right = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto expected = plain_logits(model, asked.row(i));
        for (std::size_t c = 0; c < 3; ++c)  // float against double: a few dozen roundings
            CHECK(double(answers.logits[3 * i + c]) == Approx(expected[c]).margin(2e-4));
        n_right += answers.label[i] == asked.label[i];
    }
    CHECK(n_right > 0.98 * static_cast<double>(asked.size()));
}

TEST_CASE("a convolution costs its kernel at every position; unrolled, all pairs",
          "[convolution]") {
    const Model model = trained();  // 6 positions: 1 -> 4 -> 5 channels, then 30 -> 8 -> 3
    const ModelCost cost = cost_of(model);
    CHECK(cost.multiply_accumulates == 6 * (4 * 3 + 5 * 12) + 30 * 8 + 8 * 3);
    CHECK(cost.parameters == 4 * 3 + 4 + 5 * 12 + 5 + 30 * 8 + 8 + 8 * 3 + 3);
    CHECK(cost.unrolled_multiply_accumulates == 6 * 24 + 24 * 30 + 30 * 8 + 8 * 3);
    CHECK(cost_of(unrolled(model)).multiply_accumulates == cost.unrolled_multiply_accumulates);
}

TEST_CASE("a CNN's file is read back bit for bit, and refuses what does not fit", "[convolution]") {
    const TemporaryFolder folder;
    const Model model = trained();
    write_model(model, folder / "cnn.json");
    const Model again = read_model(folder / "cnn.json");
    const FeatureTable asked = draw({.n_features = 6, .item = 1});
    CHECK(predict(fold(again), asked).logits == predict(fold(model), asked).logits);
    write_model(again, folder / "again.json");

    Model broken = model;
    broken.hidden[0].convolution->n_positions = 4;
    broken.hidden[0].n_in = 4;
    write_model(broken, folder / "broken.json");
    CHECK(message_of([&] {
              return read_model(folder / "broken.json").hidden.size();
          }).find("hidden[0].convolution.positions = 4: does not part the 6 values that come in") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
