#include "firmware/fw_softmax.h"

#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

std::vector<float> scaled(std::vector<float> values, float factor) {
    for (auto& value : values) value *= factor;
    return values;
}

}  // namespace

TEST_CASE("softmax is the normalised exponential", "[firmware]") {
    const auto n = GENERATE(as<std::uint16_t>{}, 1, 2, 5, 100);
    const auto logits = scaled(oracle::random_values(n, 6), 20);
    std::vector<float> probabilities(n);
    REQUIRE(fw_softmax(logits.data(), n, probabilities.data()) == FW_OK);
    double sum = 0;
    for (const float logit : logits) sum += std::exp(static_cast<double>(logit));
    for (std::size_t i = 0; i < n; ++i) {
        // Relative: rounding of the difference (|x| <= 40, so 32 u), of fw_exp (1.03 ulp, 2.06 u)
        // twice, of the division (u), and of n additions (n u).
        const double bound = (32 + 2 * 2.06 + 1 + n) * oracle::unit_roundoff;
        CHECK(probabilities[i] ==
              Approx(std::exp(static_cast<double>(logits[i])) / sum).epsilon(bound).margin(0));
    }
}

TEST_CASE("probabilities sum to one", "[firmware]") {
    const auto n = GENERATE(as<std::uint16_t>{}, 1, 3, 5, 257);
    const auto logits = scaled(oracle::random_values(n, 7), 10);
    std::vector<float> probabilities(n);
    REQUIRE(fw_softmax(logits.data(), n, probabilities.data()) == FW_OK);
    const double sum = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
    CHECK(std::abs(sum - 1) < (n + 1) * oracle::unit_roundoff);  // n additions, one division each
}

TEST_CASE("softmax does not overflow on the largest logits", "[firmware]") {
    const std::array logits{-FLT_MAX, FLT_MAX, 0.0F};
    std::array<float, 3> probabilities{};
    REQUIRE(fw_softmax(logits.data(), 3, probabilities.data()) == FW_OK);
    CHECK(probabilities == std::array{0.0F, 1.0F, 0.0F});
}

TEST_CASE("softmax may overwrite its own logits", "[firmware]") {
    std::array values{1.0F, -2.0F, 0.5F};
    std::array<float, 3> apart{};
    REQUIRE(fw_softmax(values.data(), 3, apart.data()) == FW_OK);
    REQUIRE(fw_softmax(values.data(), 3, values.data()) == FW_OK);
    CHECK(values == apart);
}

TEST_CASE("softmax refuses what is not a vector of finite numbers", "[firmware]") {
    std::array<float, 2> probabilities{-1, -1};
    for (const float bad : {oracle::infinity, -oracle::infinity, oracle::not_a_number}) {
        const std::array logits{0.0F, bad};
        CHECK(fw_softmax(logits.data(), 2, probabilities.data()) == FW_ERR_NONFINITE);
    }
    const std::array logits{0.0F, 1.0F};
    CHECK(fw_softmax(logits.data(), 0, probabilities.data()) == FW_ERR_SHAPE);
    CHECK(fw_softmax(nullptr, 2, probabilities.data()) == FW_ERR_NULL);
    CHECK(fw_softmax(logits.data(), 2, nullptr) == FW_ERR_NULL);
    CHECK(probabilities == std::array{-1.0F, -1.0F});
}

TEST_CASE("the largest value wins and a tie goes to the lowest index", "[firmware]") {
    const std::array values{1.0F, 3.0F, -5.0F, 3.0F, 2.0F};
    CHECK(fw_argmax(values.data(), 5) == 1);
    CHECK(fw_argmax(values.data() + 2, 3) == 1);
    CHECK(fw_argmax(values.data(), 1) == 0);
    const std::array equal{-0.0F, 0.0F};
    CHECK(fw_argmax(equal.data(), 2) == 0);
}

TEST_CASE("the largest of nothing is index zero", "[firmware]") {
    const float value = 1;
    CHECK(fw_argmax(nullptr, 5) == 0);
    CHECK(fw_argmax(&value, 0) == 0);
}
