#include "firmware/fw_exp.h"

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/check.hpp"

namespace {

constexpr float highest_x = 88.72283F;
constexpr float lowest_x = -87.336544F;

/// Distance from the true exponential, in gaps between floats at its place.
double exp_error_ulp(float x) {
    const double truth = std::exp(static_cast<double>(x));
    int exponent = 0;
    std::frexp(truth, &exponent);
    return std::abs(static_cast<double>(fw_exp(x)) - truth) / std::ldexp(1.0, exponent - 24);
}

/// Over floats of one sign from zero to `last`, every 4099th (a prime, so that all patterns of
/// low bits occur).
double worst_error_ulp(float last) {
    const auto sign = std::bit_cast<std::uint32_t>(last) & 0x80000000U;
    const auto end = std::bit_cast<std::uint32_t>(last) & 0x7FFFFFFFU;
    double worst = 0;
    for (std::uint32_t bits = 0; bits <= end; bits += 4099) {
        worst = std::max(worst, exp_error_ulp(std::bit_cast<float>(bits | sign)));
    }
    return worst;
}

}  // namespace

TEST_CASE("fw_exp is within 1.03 ulp of the true exponential", "[firmware]") {
    // All 2 237 668 968 floats of the range were tried once: 1.0246 ulp, at -81.4447098.
    CHECK(worst_error_ulp(highest_x) < 1.03);
    CHECK(worst_error_ulp(lowest_x) < 1.03);
}

TEST_CASE("fw_exp of zero is exactly one", "[firmware]") {
    CHECK(fw_exp(0.0F) == 1.0F);
    CHECK(fw_exp(-0.0F) == 1.0F);
}

TEST_CASE("fw_exp goes to zero without subnormals", "[firmware]") {
    CHECK(fw_exp(lowest_x) >= FLT_MIN);
    CHECK(fw_exp(std::nextafter(lowest_x, -100.0F)) == 0.0F);
    CHECK(fw_exp(-FLT_MAX) == 0.0F);
    CHECK(fw_exp(-std::numeric_limits<float>::infinity()) == 0.0F);
}

TEST_CASE("fw_exp stops at the largest float instead of overflowing", "[firmware]") {
    CHECK(fw_exp(highest_x) < FLT_MAX);
    CHECK(fw_exp(std::nextafter(highest_x, 100.0F)) == FLT_MAX);
    CHECK(fw_exp(std::numeric_limits<float>::infinity()) == FLT_MAX);
}

TEST_CASE("fw_exp hands NaN through", "[firmware]") {
    CHECK(std::isnan(fw_exp(std::numeric_limits<float>::quiet_NaN())));
}
