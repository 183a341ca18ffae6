#include "firmware/fw_int_mlp.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

/// A network of random integers that stays inside its own bounds. Owns what `mlp` borrows.
struct IntNetwork {
    struct Layer {
        std::vector<std::int32_t> narrow, bias, multiplier, shift;  // narrow: (out, in)
        std::vector<std::int8_t> bytes;
        std::vector<std::int16_t> halves;
        std::vector<float> scale;
    };
    std::vector<float> mean, scale;
    std::vector<Layer> layers;
    fw_int_mlp mlp{};

    IntNetwork(fw_int_width width, const std::vector<std::uint16_t>& widths, unsigned seed) {
        std::mt19937 generator(seed);
        const int largest = width == FW_INT8 ? 127 : 32767;
        mean = oracle::random_values(widths[0], seed);
        scale = oracle::random_values(widths[0], seed + 1);
        layers.resize(widths.size() - 1);
        mlp = {width,        static_cast<std::uint16_t>(layers.size()), mean.data(),
               scale.data(), static_cast<float>(largest) / 2.0F,        {}};
        for (std::size_t l = 0; l < layers.size(); ++l) {
            const std::uint16_t n_in = widths[l], n_out = widths[l + 1];
            const std::size_t stride = fw_int_stride(width, n_in);
            Layer& layer = layers[l];
            const int most = std::min(largest, (1 << 29) / largest / n_in);
            layer.bytes.assign(stride * n_out, 0);
            layer.halves.assign(stride * n_out, 0);
            for (std::size_t o = 0; o < n_out; ++o) {
                for (std::size_t i = 0; i < n_in; ++i) {
                    const int weight = static_cast<int>(generator() % (2U * most + 1)) - most;
                    layer.narrow.push_back(weight);
                    layer.bytes[o * stride + i] = static_cast<std::int8_t>(weight);
                    layer.halves[o * stride + i] = static_cast<std::int16_t>(weight);
                }
                layer.bias.push_back(static_cast<std::int32_t>(generator() % (1U << 24)) -
                                     (1 << 23));
                layer.multiplier.push_back(static_cast<std::int32_t>(generator() % (1U << 31)));
                layer.shift.push_back(width == FW_INT8 ? 42 : 45);
                layer.scale.push_back(1e-7F * static_cast<float>(o + 1));
            }
            const void* weight = width == FW_INT8 ? static_cast<const void*>(layer.bytes.data())
                                                  : static_cast<const void*>(layer.halves.data());
            mlp.layer[l] = {n_in,
                            n_out,
                            weight,
                            layer.bias.data(),
                            layer.multiplier.data(),
                            layer.shift.data(),
                            layer.scale.data()};
            REQUIRE(fw_int_layer_check(&mlp.layer[l], width, l + 1 == layers.size()) == FW_OK);
        }
    }
};

/// The header's formulas, one after the other.
std::vector<float> plainly(const IntNetwork& network, const std::vector<float>& features) {
    const std::int64_t largest = network.mlp.width == FW_INT8 ? 127 : 32767;
    std::vector<std::int64_t> values;
    for (std::size_t i = 0; i < features.size(); ++i) {
        const float x = (features[i] - network.mean[i]) * network.scale[i];
        const float level = std::round(x * network.mlp.input_levels);
        values.push_back(
            std::clamp<std::int64_t>(static_cast<std::int64_t>(level), -largest, largest));
    }
    for (std::size_t l = 0; l < network.layers.size(); ++l) {
        const auto& layer = network.layers[l];
        std::vector<std::int64_t> next;
        std::vector<float> logits;
        for (std::size_t o = 0; o < layer.bias.size(); ++o) {
            std::int64_t sum = layer.bias[o];
            for (std::size_t i = 0; i < values.size(); ++i)
                sum += layer.narrow[o * values.size() + i] * values[i];
            logits.push_back(layer.scale[o] * static_cast<float>(sum));
            const auto scaled = std::floor(static_cast<long double>(sum) * layer.multiplier[o] /
                                               std::pow(2.0L, layer.shift[o]) +
                                           0.5L);
            next.push_back(static_cast<std::int64_t>(
                std::clamp<long double>(scaled, 0, static_cast<long double>(largest))));
        }
        if (l + 1 == network.layers.size()) return logits;
        values = next;
    }
    return {};
}

std::vector<float> run(const fw_int_mlp& mlp, const std::vector<float>& features) {
    std::vector<std::int32_t> scratch(fw_int_mlp_scratch(&mlp) / 4);
    std::vector<float> logits(mlp.layer[mlp.n_layers - 1].n_out);
    REQUIRE(fw_int_mlp_run(&mlp, features.data(), scratch.data(), 4 * scratch.size(), logits.data(),
                           nullptr) == FW_OK);
    return logits;
}

}  // namespace

TEST_CASE("an integer network gives what its formulas say, bit for bit", "[firmware]") {
    const auto width = GENERATE(FW_INT8, FW_INT16);
    const auto widths =
        GENERATE(as<std::vector<std::uint16_t>>{}, std::vector<std::uint16_t>{1, 1},
                 std::vector<std::uint16_t>{12, 16, 16, 5}, std::vector<std::uint16_t>{3, 2, 7},
                 std::vector<std::uint16_t>{5, 4, 9, 8, 3}, std::vector<std::uint16_t>{130, 63, 6});
    for (unsigned seed = 0; seed < 20; ++seed) {
        const IntNetwork network(width, widths, seed);
        auto features = oracle::random_values(widths[0], 100 + seed);
        for (auto& x : features) x *= 5;  // some inputs meet the limits
        CHECK(run(network.mlp, features) == plainly(network, features));
    }
}

TEST_CASE("a sum that could leave 32 bits is refused when it is checked", "[firmware]") {
    const std::vector<std::int16_t> weight{32767, 32767};
    std::int32_t bias = 0;
    const float scale = 1;
    fw_int_layer layer{2, 1, weight.data(), &bias, nullptr, nullptr, &scale};
    CHECK(fw_int_layer_check(&layer, FW_INT16, true) == FW_OK);  // 2 * 32767^2 = 2^31 - 131070
    bias = 131069;
    CHECK(fw_int_layer_check(&layer, FW_INT16, true) == FW_OK);
    bias = 131070;
    CHECK(fw_int_layer_check(&layer, FW_INT16, true) == FW_ERR_VALUE);
    bias = std::numeric_limits<std::int32_t>::min();
    CHECK(fw_int_layer_check(&layer, FW_INT16, true) == FW_ERR_VALUE);
}

TEST_CASE("numbers out of range, missing arrays and empty layers are refused", "[firmware]") {
    const auto refused = [](auto spoil, fw_status status) {
        IntNetwork network(FW_INT8, {4, 6, 3}, 1);
        fw_int_layer& hidden = network.mlp.layer[0];
        spoil(network, hidden);
        CHECK(fw_int_layer_check(&hidden, FW_INT8, false) == status);
    };
    refused([](auto&, auto&) {}, FW_OK);
    refused([](auto& n, auto&) { n.layers[0].shift[2] = 32; }, FW_ERR_VALUE);
    refused([](auto& n, auto&) { n.layers[0].shift[2] = 63; }, FW_ERR_VALUE);
    refused([](auto& n, auto&) { n.layers[0].multiplier[5] = -1; }, FW_ERR_VALUE);
    refused([](auto&, auto& layer) { layer.multiplier = nullptr; }, FW_ERR_NULL);
    refused([](auto&, auto& layer) { layer.n_out = 0; }, FW_ERR_SHAPE);
    IntNetwork network(FW_INT8, {4, 6, 3}, 1);
    network.layers[1].scale[0] = std::numeric_limits<float>::quiet_NaN();
    CHECK(fw_int_layer_check(&network.mlp.layer[1], FW_INT8, true) == FW_ERR_VALUE);
}

TEST_CASE("an integer network refuses what the float one refuses", "[firmware]") {
    IntNetwork network(FW_INT16, {4, 6, 3}, 1);
    std::vector<float> features(4), logits(3, -1.0F);
    std::vector<std::int32_t> scratch(8);
    const auto status = [&](std::size_t bytes) {
        return fw_int_mlp_run(&network.mlp, features.data(), scratch.data(), bytes, logits.data(),
                              nullptr);
    };
    CHECK(fw_int_mlp_scratch(&network.mlp) == 32);
    CHECK(status(31) == FW_ERR_SCRATCH);
    features[1] = std::numeric_limits<float>::infinity();
    CHECK(status(32) == FW_ERR_NONFINITE);
    features[1] = 0;
    network.mlp.layer[1].n_in = 5;
    CHECK(status(32) == FW_ERR_SHAPE);
    CHECK(fw_int_mlp_scratch(&network.mlp) == 0);
    network.mlp.layer[1].n_in = 6;
    network.mlp.width = static_cast<fw_int_width>(7);
    CHECK(status(32) == FW_ERR_CONFIG);
    network.mlp.layer[0].shift = nullptr;
    CHECK(status(32) == FW_ERR_NULL);
    CHECK(logits == std::vector<float>(3, -1.0F));
}

TEST_CASE("inputs that the integers do not reach are counted, as the run cuts them off",
          "[firmware]") {
    const auto width = GENERATE(FW_INT8, FW_INT16);
    const float largest = width == FW_INT8 ? 127.0F : 32767.0F;
    const std::vector<float> mean(4, 10.0F), scale(4, 1.0F);
    fw_int_mlp mlp{};
    mlp.width = width;
    mlp.n_layers = 1;
    mlp.input_mean = mean.data();
    mlp.input_scale = scale.data();
    mlp.input_levels = largest / 6.0F;
    mlp.layer[0].n_in = 4;
    const float not_a_number = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> features{10.0F, 15.9F, 4.1F, 16.0F};  // 16 is 6 sigma: the last that fits
    CHECK(fw_int_clipped(&mlp, features.data()) == 0);
    features = {17.0F, 10.0F, 3.0F, 1e30F};
    CHECK(fw_int_clipped(&mlp, features.data()) == 3);
    features = {not_a_number, 10.0F, 10.0F, 10.0F};
    CHECK(fw_int_clipped(&mlp, features.data()) == 1);
    CHECK(fw_int_clipped(nullptr, features.data()) == 0);
    CHECK(fw_int_clipped(&mlp, nullptr) == 0);
}

TEST_CASE("padding that is not zero is refused when a layer is checked", "[firmware]") {
    std::vector<std::int8_t> weight{1, 2, 3, 0, 4, 5, 6, 0};
    const std::vector<std::int32_t> bias(2);
    const std::vector<float> scale(2, 1.0F);
    const fw_int_layer layer{3, 2, weight.data(), bias.data(), nullptr, nullptr, scale.data()};
    CHECK(fw_int_layer_check(&layer, FW_INT8, true) == FW_OK);
    weight[7] = 1;
    CHECK(fw_int_layer_check(&layer, FW_INT8, true) == FW_ERR_VALUE);
}
