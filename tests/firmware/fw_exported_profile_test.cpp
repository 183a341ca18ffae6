#include "firmware/fw_exported_profile.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "firmware/fw_extract.h"
#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

fw_window_shape blackman() {
    fw_window_shape shape{};
    REQUIRE(fw_window_find(FW_WINDOW_BLACKMAN, 128, &shape) == FW_OK);
    return shape;
}

std::vector<float> extract(const std::vector<std::int16_t>& samples, fw_extract_config config) {
    const fw_frame frame{samples.data(), 2, 3, 128};
    std::vector<float> scratch(fw_extract_scratch(&frame) / sizeof(float)), out(config.n_bins);
    REQUIRE(fw_extract(&frame, &config, scratch.data(), scratch.size() * sizeof(float),
                       out.data()) == FW_OK);
    return out;
}

}  // namespace

TEST_CASE("an exported count is the amplitude in units of the spectrum over 4", "[firmware]") {
    const auto shape = blackman();
    const std::vector<float> amplitude{0.0F, 1.0F, 100.0F, 2047.0F};
    std::vector<std::uint32_t> count(4);
    REQUIRE(fw_exported_from_amplitude(&shape, amplitude.data(), 4, count.data()) == FW_OK);
    const double unit = 0.42 * 127 / 8;  // sum of a Blackman window of 128
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(count[k] == std::lround(static_cast<double>(amplitude[k]) * unit));
    std::vector<float> back(4);
    REQUIRE(fw_exported_to_amplitude(&shape, count.data(), 4, back.data()) == FW_OK);
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(std::abs(back[k] - amplitude[k]) <= 0.5 / unit * (1 + 1e-6));
}

TEST_CASE("the exported descriptor is the mean one, rounded to whole counts", "[firmware]") {
    auto samples = oracle::random_codes(2 * 3 * 128, 5);
    for (auto& code : samples) code = static_cast<std::int16_t>(code / 16);
    const auto path = GENERATE(FW_RANGE_FLOAT, FW_RANGE_HWA_LIKE);
    fw_extract_config config{6, 12, FW_WINDOW_BLACKMAN, FW_INTEGRATE_MEAN, path};
    const auto mean = extract(samples, config);
    config.integration = FW_INTEGRATE_EXPORTED;
    const auto exported = extract(samples, config);
    const double unit = 0.42 * 127 / 8;
    bool rounded_once = false;
    for (std::size_t k = 0; k < 12; ++k) {
        const double counts = static_cast<double>(exported[k]) * unit;
        CHECK(counts == Approx(std::round(counts)).epsilon(1e-6));
        CHECK(std::abs(exported[k] - mean[k]) <= 0.5 / unit * (1 + 1e-4));
        rounded_once = rounded_once || exported[k] != mean[k];
    }
    CHECK(rounded_once);
}

TEST_CASE("the two paths to a descriptor agree within the integers of one", "[firmware]") {
    auto samples = oracle::random_codes(2 * 3 * 128, 6);
    for (auto& code : samples) code = static_cast<std::int16_t>(code / 16);
    fw_extract_config config{6, 12, FW_WINDOW_BLACKMAN, FW_INTEGRATE_MEAN, FW_RANGE_FLOAT};
    const auto real = extract(samples, config);
    config.path = FW_RANGE_HWA_LIKE;
    const auto whole = extract(samples, config);
    // A spectrum within 4 counts (fw_hwa_fft_test) is one within 4 * 8 / sum(w) LSB.
    for (std::size_t k = 0; k < 12; ++k) CHECK(std::abs(real[k] - whole[k]) < 4.0 * 8 / 53.3);
    CHECK(real != whole);
}

TEST_CASE("no count is made of a number that has none", "[firmware]") {
    const auto shape = blackman();
    std::uint32_t count = 7;
    const auto status = [&](float amplitude) {
        return fw_exported_from_amplitude(&shape, &amplitude, 1, &count);
    };
    CHECK(status(std::numeric_limits<float>::quiet_NaN()) == FW_ERR_NONFINITE);
    CHECK(status(std::numeric_limits<float>::infinity()) == FW_ERR_NONFINITE);
    CHECK(status(-1.0F) == FW_ERR_NONFINITE);
    CHECK(status(7e8F) == FW_ERR_NONFINITE);
    CHECK(count == 7);
    CHECK(status(6e8F) == FW_OK);
    CHECK(fw_exported_from_amplitude(&shape, nullptr, 1, &count) == FW_ERR_NULL);
    const float one = 1;
    CHECK(fw_exported_from_amplitude(&shape, &one, 0, &count) == FW_ERR_SHAPE);
    float back = 0;
    CHECK(fw_exported_to_amplitude(&shape, &count, 0, &back) == FW_ERR_SHAPE);
    CHECK(fw_exported_to_amplitude(nullptr, &count, 1, &back) == FW_ERR_NULL);
}
