#include "firmware/fw_mlp.h"

#include <array>
#include <cfloat>
#include <limits>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

/// A network with random weights that owns its arrays.
struct Network {
    std::vector<std::vector<float>> weights, biases;
    std::vector<float> mean, scale;
    fw_mlp mlp{};

    explicit Network(const std::vector<std::uint16_t>& widths)
        : mean(oracle::random_values(widths[0], 20)), scale(oracle::random_values(widths[0], 21)) {
        mlp.n_layers = static_cast<std::uint16_t>(widths.size() - 1);
        mlp.input_mean = mean.data();
        mlp.input_scale = scale.data();
        for (unsigned i = 0; i + 1 < widths.size(); ++i) {
            const auto n_in = widths[i], n_out = widths[i + 1];
            weights.push_back(oracle::random_values(std::size_t{n_in} * n_out, 30 + i));
            biases.push_back(oracle::random_values(n_out, 40 + i));
            mlp.layer[i] = {n_in, n_out, weights.back().data(), biases.back().data()};
        }
    }
};

/// The network as one would first write it down.
std::vector<float> plainly(const fw_mlp& mlp, std::vector<float> x) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (mlp.input_mean != nullptr) x[i] = (x[i] - mlp.input_mean[i]) * mlp.input_scale[i];
    }
    for (int l = 0; l < mlp.n_layers; ++l) {
        const auto& layer = mlp.layer[l];
        std::vector<float> y(layer.bias, layer.bias + layer.n_out);
        for (std::size_t o = 0; o < layer.n_out; ++o) {
            for (std::size_t i = 0; i < layer.n_in; ++i) {
                y[o] += layer.weight[o * layer.n_in + i] * x[i];
            }
            if (l + 1 < mlp.n_layers && y[o] < 0) y[o] = 0;
        }
        x = y;
    }
    return x;
}

std::vector<float> run(const fw_mlp& mlp, const std::vector<float>& features) {
    std::vector<float> scratch(fw_mlp_scratch(&mlp) / sizeof(float));
    std::vector<float> logits(mlp.layer[mlp.n_layers - 1].n_out);
    REQUIRE(fw_mlp_run(&mlp, features.data(), scratch.data(), scratch.size() * sizeof(float),
                       logits.data(), nullptr) == FW_OK);
    return logits;
}

}  // namespace

TEST_CASE("the blocked network gives the plain loop's result, bit for bit", "[firmware]") {
    const auto widths =
        GENERATE(as<std::vector<std::uint16_t>>{}, std::vector<std::uint16_t>{1, 1},
                 std::vector<std::uint16_t>{3, 2, 7}, std::vector<std::uint16_t>{12, 16, 16, 5},
                 std::vector<std::uint16_t>{5, 4, 9, 8, 3}, std::vector<std::uint16_t>{130, 64, 6});
    Network network(widths);
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto features = oracle::random_values(widths[0], 100 + seed);
        CHECK(run(network.mlp, features) == plainly(network.mlp, features));
    }
    network.mlp.input_mean = network.mlp.input_scale = nullptr;
    const auto features = oracle::random_values(widths[0], 200);
    CHECK(run(network.mlp, features) == plainly(network.mlp, features));
}

TEST_CASE("a network worked by hand computes exclusive or", "[firmware]") {
    // hidden = (a + b, a + b - 1), out = hidden0 - 2 hidden1, after inputs in {-1, 3} are brought
    // to {0, 1}; the second output is negative, since no ReLU follows the last layer.
    const std::array<float, 4> hidden_weight{1, 1, 1, 1};
    const std::array<float, 2> hidden_bias{0, -1};
    const std::array<float, 4> out_weight{1, -2, -1, 2};
    const std::array<float, 2> out_bias{0, 0};
    const std::array<float, 2> mean{-1, -1}, scale{0.25, 0.25};
    const fw_mlp mlp{.n_layers = 2,
                     .input_mean = mean.data(),
                     .input_scale = scale.data(),
                     .layer = {{2, 2, hidden_weight.data(), hidden_bias.data()},
                               {2, 2, out_weight.data(), out_bias.data()}}};
    CHECK(run(mlp, {-1, -1}) == std::vector<float>{0, 0});
    CHECK(run(mlp, {-1, 3}) == std::vector<float>{1, -1});
    CHECK(run(mlp, {3, -1}) == std::vector<float>{1, -1});
    CHECK(run(mlp, {3, 3}) == std::vector<float>{0, 0});
}

TEST_CASE("the bias is the first term of the sum", "[firmware]") {
    const std::array<float, 2> weight{1, 1};
    const float bias = 1;
    const fw_mlp mlp{.n_layers = 1,
                     .input_mean = nullptr,
                     .input_scale = nullptr,
                     .layer = {{2, 1, weight.data(), &bias}}};
    // (1 + 2^-24) + 2^-24 rounds to 1 twice; with the bias last it would be 1 + 2^-23.
    CHECK(run(mlp, {0x1p-24F, 0x1p-24F}) == std::vector<float>{1.0F});
}

TEST_CASE("probabilities are the softmax of the logits, and logits do not need them",
          "[firmware]") {
    const Network network({12, 16, 5});
    const auto features = oracle::random_values(12, 50);
    std::vector<float> scratch(32), logits(5), probabilities(5), expected(5);
    REQUIRE(fw_mlp_run(&network.mlp, features.data(), scratch.data(), 128, logits.data(),
                       probabilities.data()) == FW_OK);
    CHECK(logits == run(network.mlp, features));
    REQUIRE(fw_softmax(logits.data(), 5, expected.data()) == FW_OK);
    CHECK(probabilities == expected);
}

TEST_CASE("scratch is two arrays of the widest layer and nothing behind it is written",
          "[firmware]") {
    const auto widest_in = Network({20, 8, 5}), widest_out = Network({3, 4, 20});
    for (const auto* network : {&widest_in, &widest_out}) {
        CHECK(fw_mlp_scratch(&network->mlp) == 2 * 20 * sizeof(float));
        std::vector<float> scratch(41, oracle::not_a_number), logits(20);
        scratch.back() = 42;
        const auto features = oracle::random_values(20, 51);
        REQUIRE(fw_mlp_run(&network->mlp, features.data(), scratch.data(), 160, logits.data(),
                           nullptr) == FW_OK);
        CHECK(scratch.back() == 42);
    }
}

TEST_CASE("a network whose layers do not fit is refused", "[firmware]") {
    const auto refused = [](auto spoil) {
        Network network({4, 6, 3});
        spoil(network.mlp);
        const std::vector<float> features(8);
        std::vector<float> scratch(64), logits(8, -1.0F);
        CHECK(fw_mlp_scratch(&network.mlp) == 0);
        CHECK(fw_mlp_run(&network.mlp, features.data(), scratch.data(), 256, logits.data(),
                         nullptr) == FW_ERR_SHAPE);
        CHECK(logits == std::vector<float>(8, -1.0F));
    };
    refused([](fw_mlp& mlp) { mlp.n_layers = 0; });
    refused([](fw_mlp& mlp) { mlp.n_layers = FW_MLP_MAX_LAYERS + 1; });
    refused([](fw_mlp& mlp) { mlp.layer[1].n_in = 5; });
    refused([](fw_mlp& mlp) { mlp.layer[0].n_in = 0; });
    refused([](fw_mlp& mlp) { mlp.layer[1].n_out = 0; });
    CHECK(fw_mlp_scratch(nullptr) == 0);
}

TEST_CASE("what is not finite is refused, on the way in and on the way out", "[firmware]") {
    const Network network({3, 4, 2});
    std::vector<float> scratch(8), logits(2, -1.0F), probabilities(2, -1.0F);
    const auto status = [&](const fw_mlp& mlp, const std::vector<float>& features) {
        return fw_mlp_run(&mlp, features.data(), scratch.data(), 32, logits.data(),
                          probabilities.data());
    };
    for (const float bad : {oracle::infinity, -oracle::infinity, oracle::not_a_number}) {
        CHECK(status(network.mlp, {0, bad, 0}) == FW_ERR_NONFINITE);
    }

    // Two features, one hidden value, two logits. A hidden infinity reaches the logits, and a
    // hidden NaN (infinity minus infinity) must not end as ReLU's zero on the way.
    const std::array<float, 2> huge{FLT_MAX, -FLT_MAX}, ones{1, 1}, zeros{0, 0};
    const fw_mlp overflowing{
        .n_layers = 2,
        .input_mean = nullptr,
        .input_scale = nullptr,
        .layer = {{2, 1, huge.data(), zeros.data()}, {1, 2, ones.data(), zeros.data()}}};
    CHECK(status(overflowing, {2, 0}) == FW_ERR_NONFINITE);
    CHECK(status(overflowing, {2, 3}) == FW_ERR_NONFINITE);
    CHECK(logits == std::vector<float>(2, -1.0F));
    CHECK(probabilities == std::vector<float>(2, -1.0F));
}

TEST_CASE("a network is not run through missing or unfit memory", "[firmware]") {
    Network network({4, 6, 3});
    const std::vector<float> features(4);
    std::vector<float> scratch(14), logits(3, -1.0F);
    const auto* mlp = &network.mlp;
    const auto* x = features.data();
    auto* lent = scratch.data();
    CHECK(fw_mlp_run(nullptr, x, lent, 48, logits.data(), nullptr) == FW_ERR_NULL);
    CHECK(fw_mlp_run(mlp, nullptr, lent, 48, logits.data(), nullptr) == FW_ERR_NULL);
    CHECK(fw_mlp_run(mlp, x, nullptr, 48, logits.data(), nullptr) == FW_ERR_NULL);
    CHECK(fw_mlp_run(mlp, x, lent, 48, nullptr, nullptr) == FW_ERR_NULL);
    CHECK(fw_mlp_run(mlp, x, lent, 47, logits.data(), nullptr) == FW_ERR_SCRATCH);
    auto* misaligned = reinterpret_cast<char*>(lent) + 1;
    CHECK(fw_mlp_run(mlp, x, misaligned, 48, logits.data(), nullptr) == FW_ERR_SCRATCH);

    const auto missing = [&](auto& pointer) {
        const auto* kept = pointer;
        pointer = nullptr;
        CHECK(fw_mlp_run(mlp, x, lent, 48, logits.data(), nullptr) == FW_ERR_NULL);
        pointer = kept;
    };
    missing(network.mlp.input_mean);
    missing(network.mlp.input_scale);
    missing(network.mlp.layer[0].weight);
    missing(network.mlp.layer[1].bias);
    CHECK(logits == std::vector<float>(3, -1.0F));
    CHECK(fw_mlp_run(mlp, x, lent, 48, logits.data(), nullptr) == FW_OK);
}
