#include "firmware/fw_frame_quality.h"

#include <cstdint>
#include <vector>

#include "tests/check.hpp"

namespace {

/// Two chirps of three antennas, a quiet ramp everywhere.
std::vector<std::int16_t> quiet() {
    std::vector<std::int16_t> samples(2 * 3 * 16);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<std::int16_t>(i % 16);
    return samples;
}

fw_frame_quality inspect(const std::vector<std::int16_t>& samples, std::uint16_t adc_bits) {
    const fw_frame frame{samples.data(), 2, 3, 16};
    fw_frame_quality quality{};
    REQUIRE(fw_frame_inspect(&frame, adc_bits, &quality) == FW_OK);
    return quality;
}

}  // namespace

TEST_CASE("a clean frame is found clean", "[firmware]") {
    const auto quality = inspect(quiet(), 12);
    CHECK(quality.n_saturated == 0);
    CHECK(quality.n_dead_rows == 0);
    CHECK(quality.peak == 15);
}

TEST_CASE("samples at either limit of the converter are counted, one code inside is not",
          "[firmware]") {
    auto samples = quiet();
    samples[5] = 2047;
    samples[95] = -2048;
    CHECK(inspect(samples, 12).n_saturated == 2);
    CHECK(inspect(samples, 12).peak == 2048);
    CHECK(inspect(samples, 16).n_saturated == 0);
    samples[5] = 2046;
    samples[95] = -2047;
    CHECK(inspect(samples, 12).n_saturated == 0);
    samples[0] = -32768;
    CHECK(inspect(samples, 16).n_saturated == 1);
    CHECK(inspect(samples, 16).peak == 32768);
}

TEST_CASE("a row that never moves is dead, whatever its value", "[firmware]") {
    auto samples = quiet();
    for (std::size_t i = 32; i < 48; ++i) samples[i] = 0;
    for (std::size_t i = 80; i < 96; ++i) samples[i] = 9;
    CHECK(inspect(samples, 12).n_dead_rows == 2);
}

TEST_CASE("a frame that cannot be inspected is refused", "[firmware]") {
    const auto samples = quiet();
    fw_frame_quality quality{.n_saturated = 7, .n_dead_rows = 7, .peak = 7};
    const auto status = [&](fw_frame frame, std::uint16_t bits) {
        return fw_frame_inspect(&frame, bits, &quality);
    };
    CHECK(status({nullptr, 2, 3, 16}, 12) == FW_ERR_NULL);
    CHECK(status({samples.data(), 0, 3, 16}, 12) == FW_ERR_SHAPE);
    CHECK(status({samples.data(), 2, 0, 16}, 12) == FW_ERR_SHAPE);
    CHECK(status({samples.data(), 2, 3, 15}, 12) == FW_ERR_SHAPE);
    CHECK(status({samples.data(), 2, 3, 16}, 1) == FW_ERR_CONFIG);
    CHECK(status({samples.data(), 2, 3, 16}, 17) == FW_ERR_CONFIG);
    CHECK(fw_frame_inspect(nullptr, 12, &quality) == FW_ERR_NULL);
    CHECK(quality.n_saturated == 7);
}
