#include "classifier/mlp_network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/check.hpp"
#include "tests/classifier/gradient_check.hpp"

namespace specula {
namespace {

/// A small network with nothing at its starting value, and one batch for it.
struct MlpExample {
    explicit MlpExample(const std::vector<int>& widths, int n_examples = 12)
        : network(initial_network<double>(widths, stream)),
          inputs(Matrix<double>::NullaryExpr(widths.front(), n_examples,
                                             [&] { return stream.normal(); })),
          workspace(network, n_examples) {
        for (auto& layer : network.layers) {
            for (double& gamma : layer.gamma) gamma += 0.3 * stream.normal();
            for (double& beta : layer.beta) beta += 0.3 * stream.normal();
        }
        std::vector<std::uint8_t> labels;
        for (int i = 0; i < n_examples; ++i)
            labels.push_back(
                static_cast<std::uint8_t>(stream.below(static_cast<std::uint32_t>(widths.back()))));
        std::vector<std::uint32_t> all(labels.size());
        std::iota(all.begin(), all.end(), 0u);
        load_batch<double>(inputs, labels, all, workspace);
    }

    double loss() { return forward_train(network, workspace); }

    Stream stream{{.seed = 3, .purpose = "mlp network test"}};
    MlpNetwork<double> network;
    Matrix<double> inputs;
    MlpWorkspace<double> workspace;
};

/// Largest difference of the gradient from central differences over one array.
template <typename Array>
double gradient_difference(MlpExample& example, Array& parameters, const Array& gradient) {
    constexpr double h = 1e-5;  // truncation and rounding both near 1e-11
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

TEST_CASE("gradients are the slopes of the loss", "[mlp]") {
    const auto widths =
        GENERATE(values<std::vector<int>>({{4, 3}, {4, 6, 3}, {5, 7, 6, 4}, {3, 4, 4, 4, 2}}));
    MlpExample example(widths);
    example.loss();
    REQUIRE(distance_from_kinks(example.network, example.workspace) > 1e-4);
    backward(example.network, example.workspace);
    const auto gradient = example.workspace.gradient;
    for (std::size_t l = 0; l < gradient.size(); ++l) {
        CAPTURE(l);
        auto& layer = example.network.layers[l];
        CHECK(gradient_difference(example, layer.weight, gradient[l].weight) < 1e-8);
        CHECK(gradient_difference(example, layer.bias, gradient[l].bias) < 1e-8);
        CHECK(gradient_difference(example, layer.gamma, gradient[l].gamma) < 1e-8);
        CHECK(gradient_difference(example, layer.beta, gradient[l].beta) < 1e-8);
    }
}

TEST_CASE("the loss of equal logits is the logarithm of the number of classes", "[mlp]") {
    MlpExample example({4, 5});
    example.network.layers[0].weight.setZero();
    example.network.layers[0].bias.setConstant(7.0);
    CHECK(example.loss() == Approx(std::log(5.0)).epsilon(1e-15));
}

TEST_CASE("logits far beyond the range of exp give a finite loss", "[mlp]") {
    MlpExample example({4, 2}, 2);
    example.network.layers[0].weight.setZero();
    example.network.layers[0].bias << 1e4, -1e4;
    example.workspace.label = {0, 1};
    CHECK(example.loss() == Approx(1e4));  // mean of 0 and 2e4
}

TEST_CASE("a step does not depend on what else fits into the buffers", "[mlp]") {
    const std::vector<std::uint32_t> chosen{5, 0, 3, 9, 1};
    MlpExample example({4, 6, 3});
    const std::vector<std::uint8_t> labels = example.workspace.label;
    MlpWorkspace<double> exact(example.network, 5);
    auto same = example.network;
    load_batch<double>(example.inputs, labels, chosen, example.workspace);
    load_batch<double>(example.inputs, labels, chosen, exact);
    CHECK(example.loss() == forward_train(same, exact));
    backward(example.network, example.workspace);
    backward(same, exact);
    for (std::size_t l = 0; l < exact.gradient.size(); ++l)
        CHECK(exact.gradient[l].weight == example.workspace.gradient[l].weight);
}

TEST_CASE("running statistics settle at the mean and the unbiased variance of the sums", "[mlp]") {
    MlpExample example({4, 6, 3});
    for (int i = 0; i < 400; ++i) example.loss();  // 0.9^400 = 5e-19: the start is forgotten
    const Matrix<double> sums = example.network.layers[0].weight * example.inputs;
    for (Eigen::Index unit = 0; unit < sums.rows(); ++unit) {
        const double mean = sums.row(unit).sum() / 12.0;
        const double variance = (sums.row(unit).array() - mean).square().sum() / 11.0;
        CHECK(example.network.running[0].mean(unit) == Approx(mean).epsilon(1e-12).margin(1e-14));
        CHECK(example.network.running[0].variance(unit) == Approx(variance).epsilon(1e-12));
    }
}

TEST_CASE("weights start inside the reciprocal root of the number of inputs", "[mlp]") {
    Stream stream({.seed = 1, .purpose = "mlp network test"});
    const auto network = initial_network<float>({16, 64, 3}, stream);
    REQUIRE(network.n_hidden() == 1);
    CHECK(network.layers[0].bias.size() == 0);
    CHECK(network.layers[0].weight.cwiseAbs().maxCoeff() <= 0.25f);
    CHECK(network.layers[0].weight.maxCoeff() > 0.24f);  // 1024 draws come near the bound
    CHECK(network.layers[0].weight.minCoeff() < -0.24f);
    CHECK(network.layers[1].weight.cwiseAbs().maxCoeff() <= 0.125f);
    CHECK(network.layers[1].bias.cwiseAbs().maxCoeff() <= 0.125f);
}

}  // namespace
}  // namespace specula
