#include "firmware/fw_window.h"

#include <cmath>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

TEST_CASE("windowed samples are samples times the textbook window", "[firmware]") {
    const auto kind = GENERATE(FW_WINDOW_RECT, FW_WINDOW_HANN, FW_WINDOW_BLACKMAN);
    const auto n = GENERATE(as<std::uint16_t>{}, 64, 128, 256, 512);
    const auto samples = oracle::random_codes(n, 1);
    fw_window_shape shape{};
    std::vector<float> windowed(n);
    REQUIRE(fw_window_find(kind, n, &shape) == FW_OK);
    REQUIRE(fw_window_apply(&shape, samples.data(), windowed.data()) == FW_OK);
    for (std::size_t i = 0; i < n; ++i) {
        // Two roundings, of the table and of the product, each half a gap of floats below 2^15.
        CHECK(std::abs(windowed[i] - samples[i] * oracle::window(kind, i, n)) <= 0x1p-9);
    }
}

TEST_CASE("a rectangular window leaves samples as they are, at any length", "[firmware]") {
    const auto n = GENERATE(as<std::uint16_t>{}, 16, 17, 100, 1023, 1024);
    const auto samples = oracle::random_codes(n, 2);
    fw_window_shape shape{};
    std::vector<float> windowed(n);
    REQUIRE(fw_window_find(FW_WINDOW_RECT, n, &shape) == FW_OK);
    CHECK(shape.sum == static_cast<float>(n));
    REQUIRE(fw_window_apply(&shape, samples.data(), windowed.data()) == FW_OK);
    CHECK(windowed == std::vector<float>(samples.begin(), samples.end()));
}

TEST_CASE("a window that cannot be found leaves the shape untouched", "[firmware]") {
    const fw_window_shape before{.half = nullptr, .sum = -1, .n_samples = 7};
    fw_window_shape shape = before;
    CHECK(fw_window_find(FW_WINDOW_HANN, 65, &shape) == FW_ERR_SHAPE);
    CHECK(fw_window_find(FW_WINDOW_BLACKMAN, 1024, &shape) == FW_ERR_SHAPE);
    CHECK(fw_window_find(FW_WINDOW_RECT, 15, &shape) == FW_ERR_SHAPE);
    CHECK(fw_window_find(FW_WINDOW_RECT, 1025, &shape) == FW_ERR_SHAPE);
    CHECK(fw_window_find(static_cast<fw_window>(3), 64, &shape) == FW_ERR_CONFIG);
    CHECK(shape.half == before.half);
    CHECK(shape.sum == before.sum);
    CHECK(shape.n_samples == before.n_samples);
    CHECK(fw_window_find(FW_WINDOW_RECT, 64, nullptr) == FW_ERR_NULL);
}

TEST_CASE("a window is not applied through missing pointers", "[firmware]") {
    const fw_window_shape shape{.half = nullptr, .sum = 1, .n_samples = 1};
    const std::int16_t sample = 5;
    float windowed = -1;
    CHECK(fw_window_apply(nullptr, &sample, &windowed) == FW_ERR_NULL);
    CHECK(fw_window_apply(&shape, nullptr, &windowed) == FW_ERR_NULL);
    CHECK(fw_window_apply(&shape, &sample, nullptr) == FW_ERR_NULL);
    CHECK(windowed == -1.0F);
}
