#include "firmware/fw_extract.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include "firmware/fw_range_profile.h"
#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

constexpr fw_extract_config single{.first_bin = FW_DEFAULT_FIRST_BIN,
                                   .n_bins = FW_DEFAULT_N_BINS,
                                   .window = FW_WINDOW_BLACKMAN,
                                   .integration = FW_INTEGRATE_SINGLE,
                                   .path = FW_RANGE_FLOAT};
constexpr fw_extract_config mean{.first_bin = FW_DEFAULT_FIRST_BIN,
                                 .n_bins = FW_DEFAULT_N_BINS,
                                 .window = FW_WINDOW_BLACKMAN,
                                 .integration = FW_INTEGRATE_MEAN,
                                 .path = FW_RANGE_FLOAT};

/// A frame that owns its samples, (chirp, rx, sample).
struct Recording {
    std::uint16_t n_chirps, n_rx, n_samples;
    std::vector<std::int16_t> samples;

    fw_frame view() const { return {samples.data(), n_chirps, n_rx, n_samples}; }
    const std::int16_t* row(std::size_t index) const { return samples.data() + index * n_samples; }
};

Recording random_recording(std::uint16_t n_chirps, std::uint16_t n_rx, std::uint16_t n_samples) {
    const auto n = static_cast<std::size_t>(n_chirps) * n_rx * n_samples;
    return {n_chirps, n_rx, n_samples, oracle::random_codes(n, 11)};
}

std::vector<float> extract(const Recording& recording, const fw_extract_config& config) {
    const auto frame = recording.view();
    std::vector<float> scratch(fw_extract_scratch(&frame) / sizeof(float));
    std::vector<float> out(config.n_bins, -1.0F);  // must be overwritten, not added to
    REQUIRE(fw_extract(&frame, &config, scratch.data(), scratch.size() * sizeof(float),
                       out.data()) == FW_OK);
    return out;
}

std::vector<float> profile_of_row(const Recording& recording, std::size_t row) {
    const fw_range_config config{.n_samples = recording.n_samples,
                                 .first_bin = single.first_bin,
                                 .n_bins = single.n_bins,
                                 .window = single.window};
    std::vector<float> scratch(recording.n_samples), out(single.n_bins);
    REQUIRE(fw_range_profile(recording.row(row), &config, scratch.data(),
                             scratch.size() * sizeof(float), out.data()) == FW_OK);
    return out;
}

}  // namespace

TEST_CASE("the default descriptor is the twelve bins 6 to 17", "[firmware]") {
    CHECK(FW_DEFAULT_FIRST_BIN == 6);
    CHECK(FW_DEFAULT_FIRST_BIN + FW_DEFAULT_N_BINS - 1 == 17);
}

TEST_CASE("single integration is the range profile of chirp 0, rx 0, bit for bit", "[firmware]") {
    const auto recording = random_recording(3, 2, 128);
    CHECK(extract(recording, single) == profile_of_row(recording, 0));
}

TEST_CASE("mean integration is the mean of all rows' range profiles", "[firmware]") {
    const auto recording = random_recording(5, 3, 128);
    const auto out = extract(recording, mean);
    std::vector<double> sum(out.size());
    for (std::size_t row = 0; row < 15; ++row) {
        const auto amplitude = profile_of_row(recording, row);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += amplitude[k];
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
        // Fourteen additions and one division of positive numbers.
        CHECK(std::abs(out[k] - sum[k] / 15) <= 15 * oracle::unit_roundoff * sum[k] / 15);
    }
}

TEST_CASE("rows in antiphase do not cancel: the mean is of magnitudes", "[firmware]") {
    auto recording = random_recording(2, 1, 256);
    for (std::size_t i = 0; i < 256; ++i) {
        recording.samples[i] = static_cast<std::int16_t>(recording.samples[i] / 2);
        recording.samples[256 + i] = static_cast<std::int16_t>(-recording.samples[i]);
    }
    CHECK(extract(recording, mean) == extract(recording, single));
}

TEST_CASE("the mean of one row is that row, bit for bit", "[firmware]") {
    const auto recording = random_recording(1, 1, 512);
    CHECK(extract(recording, mean) == extract(recording, single));
}

TEST_CASE("rows of any length from 16 to 1024 are accepted without a window", "[firmware]") {
    const auto n_samples = GENERATE(as<std::uint16_t>{}, 16, 33, 100, 777, 1024);
    const auto recording = random_recording(2, 2, n_samples);
    const auto half = static_cast<std::uint16_t>(fw_range_fft_size(n_samples) / 2);
    const auto out = extract(recording, {.first_bin = 0,
                                         .n_bins = half,
                                         .window = FW_WINDOW_RECT,
                                         .integration = FW_INTEGRATE_MEAN,
                                         .path = FW_RANGE_FLOAT});
    for (const float amplitude : out) CHECK(amplitude > 0);  // the signal is noise in all bins
}

TEST_CASE("scratch needs no preparation and nothing behind it is written", "[firmware]") {
    const auto recording = random_recording(4, 3, 100);
    const fw_extract_config config{.first_bin = 0,
                                   .n_bins = 64,
                                   .window = FW_WINDOW_RECT,
                                   .integration = FW_INTEGRATE_MEAN,
                                   .path = FW_RANGE_FLOAT};
    const auto frame = recording.view();
    const auto bytes = fw_extract_scratch(&frame);
    CHECK(bytes == (2 * 128 + 64) * sizeof(float));
    std::vector<float> scratch(bytes / sizeof(float) + 1, std::numeric_limits<float>::quiet_NaN());
    scratch.back() = 42;
    std::vector<float> out(64);
    REQUIRE(fw_extract(&frame, &config, scratch.data(), bytes, out.data()) == FW_OK);
    CHECK(scratch.back() == 42);
    CHECK(out == extract(recording, config));
}

TEST_CASE("an unsupported frame needs no scratch", "[firmware]") {
    CHECK(fw_extract_scratch(nullptr) == 0);
    for (const fw_frame& frame : {fw_frame{nullptr, 0, 1, 64}, fw_frame{nullptr, 1, 0, 64},
                                  fw_frame{nullptr, 1, 1, 15}, fw_frame{nullptr, 1, 1, 1025}}) {
        CHECK(fw_extract_scratch(&frame) == 0);
    }
    const fw_frame unread{nullptr, 65535, 65535, 1024};  // a shape has a size without its samples
    CHECK(fw_extract_scratch(&unread) == 10240);
}

TEST_CASE("a frame that cannot be extracted leaves the output untouched", "[firmware]") {
    const auto recording = random_recording(2, 2, 128);
    const auto frame = recording.view();
    const auto bytes = fw_extract_scratch(&frame);
    std::vector<float> scratch(2048);
    const std::vector<float> before(64, -1.0F);
    auto out = before;

    const auto status_of_frame = [&](fw_frame bad) {
        return fw_extract(&bad, &mean, scratch.data(), 8192, out.data());
    };
    const auto* samples = recording.samples.data();
    CHECK(status_of_frame({nullptr, 2, 2, 128}) == FW_ERR_NULL);
    CHECK(status_of_frame({samples, 0, 2, 128}) == FW_ERR_SHAPE);
    CHECK(status_of_frame({samples, 2, 0, 128}) == FW_ERR_SHAPE);
    CHECK(status_of_frame({samples, 1, 1, 15}) == FW_ERR_SHAPE);
    CHECK(status_of_frame({samples, 1, 1, 1025}) == FW_ERR_SHAPE);
    CHECK(status_of_frame({samples, 1, 1, 127}) == FW_ERR_SHAPE);  // no Blackman table

    const auto status_of_config = [&](fw_extract_config bad) {
        return fw_extract(&frame, &bad, scratch.data(), bytes, out.data());
    };
    auto config = mean;
    config.n_bins = 0;
    CHECK(status_of_config(config) == FW_ERR_CONFIG);
    config.n_bins = 59;  // one beyond bin 63
    CHECK(status_of_config(config) == FW_ERR_CONFIG);
    config = mean;
    config.window = static_cast<fw_window>(3);
    CHECK(status_of_config(config) == FW_ERR_CONFIG);
    config = mean;
    const int no_such_choice = 3;  // as a C caller could pass it
    std::memcpy(&config.integration, &no_such_choice, sizeof no_such_choice);
    CHECK(status_of_config(config) == FW_ERR_CONFIG);
    config = mean;
    std::memcpy(&config.path, &no_such_choice, sizeof no_such_choice);
    CHECK(status_of_config(config) == FW_ERR_CONFIG);

    auto* lent = scratch.data();
    CHECK(fw_extract(&frame, &mean, lent, bytes - 1, out.data()) == FW_ERR_SCRATCH);
    auto* misaligned = reinterpret_cast<char*>(lent) + 1;
    CHECK(fw_extract(&frame, &mean, misaligned, bytes, out.data()) == FW_ERR_SCRATCH);
    CHECK(fw_extract(nullptr, &mean, lent, bytes, out.data()) == FW_ERR_NULL);
    CHECK(fw_extract(&frame, nullptr, lent, bytes, out.data()) == FW_ERR_NULL);
    CHECK(fw_extract(&frame, &mean, nullptr, bytes, out.data()) == FW_ERR_NULL);
    CHECK(fw_extract(&frame, &mean, lent, bytes, nullptr) == FW_ERR_NULL);
    CHECK(out == before);
}

TEST_CASE("bins that the HWA-like transform cuts off are counted, and those outside are not",
          "[firmware]") {
    // 2000 LSB at bin 20 of 512 samples are 53,650 counts, beyond int16; the float path has no
    // limit, and reads 2000 LSB.
    Recording recording{2, 1, 512, std::vector<std::int16_t>(1024)};
    for (std::size_t i = 0; i < 1024; ++i) {
        const double angle = 2 * std::numbers::pi * 20 * static_cast<double>(i % 512) / 512;
        recording.samples[i] = static_cast<std::int16_t>(std::lround(2000 * std::cos(angle)));
    }
    const auto frame = recording.view();
    std::vector<float> scratch(fw_extract_scratch(&frame) / sizeof(float)), out(4);
    const auto counted = [&](std::uint16_t first, fw_range_path path) {
        const fw_extract_config config{first, 4, FW_WINDOW_BLACKMAN, FW_INTEGRATE_MEAN, path};
        std::uint32_t n = 77;
        REQUIRE(fw_extract_counted(&frame, &config, scratch.data(), 4 * scratch.size(), out.data(),
                                   &n) == FW_OK);
        return n;
    };
    CHECK(counted(19, FW_RANGE_HWA_LIKE) == 2);  // the real part of bin 20, in either row
    CHECK(out[1] < 1300.0F);
    CHECK(counted(40, FW_RANGE_HWA_LIKE) == 0);
    CHECK(counted(19, FW_RANGE_FLOAT) == 0);
    CHECK(out[1] == Approx(2000).epsilon(1e-3));
    const fw_extract_config config{19, 4, FW_WINDOW_BLACKMAN, FW_INTEGRATE_MEAN, FW_RANGE_FLOAT};
    CHECK(fw_extract_counted(&frame, &config, scratch.data(), 4 * scratch.size(), out.data(),
                             nullptr) == FW_ERR_NULL);
}
