#include "firmware/fw_range_profile.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

using Codes = std::vector<std::int16_t>;

/// fw_range_profile with scratch of exactly the size it asks for.
std::vector<float> profile(const Codes& samples, const fw_range_config& config) {
    std::vector<float> scratch(fw_range_profile_scratch(config.n_samples) / sizeof(float));
    std::vector<float> amplitude(config.n_bins);
    REQUIRE(fw_range_profile(samples.data(), &config, scratch.data(),
                             scratch.size() * sizeof(float), amplitude.data()) == FW_OK);
    return amplitude;
}

/// The whole spectrum, zero-padded.
fw_range_config all_bins(std::uint16_t n_samples, fw_window window) {
    return {.n_samples = n_samples,
            .first_bin = 0,
            .n_bins = static_cast<std::uint16_t>(fw_range_fft_size(n_samples) / 2),
            .window = window};
}

Codes tone(std::uint16_t n_samples, double amplitude, double cycles) {
    Codes codes(n_samples);
    for (std::size_t i = 0; i < n_samples; ++i) {
        const double turns = cycles * static_cast<double>(i) / n_samples;
        codes[i] = static_cast<std::int16_t>(
            std::lround(amplitude * std::cos(2 * std::numbers::pi * turns + 0.7)));
    }
    return codes;
}

/// What a tone leaves `distance` bins away, relative to its own amplitude.
double leakage(fw_window window, std::size_t n_samples, int distance) {
    std::complex<double> away;
    double sum = 0;
    for (std::size_t i = 0; i < n_samples; ++i) {
        const double turns = distance * static_cast<double>(i) / static_cast<double>(n_samples);
        const double w = oracle::window(window, i, n_samples);
        away += w * std::polar(1.0, 2 * std::numbers::pi * turns);
        sum += w;
    }
    return std::abs(away) / sum;
}

}  // namespace

TEST_CASE("the transform is the next power of two from 16 to 1024", "[firmware]") {
    CHECK(fw_range_fft_size(16) == 16);
    CHECK(fw_range_fft_size(17) == 32);
    CHECK(fw_range_fft_size(100) == 128);
    CHECK(fw_range_fft_size(128) == 128);
    CHECK(fw_range_fft_size(513) == 1024);
    CHECK(fw_range_fft_size(1024) == 1024);
    CHECK(fw_range_fft_size(15) == 0);
    CHECK(fw_range_fft_size(1025) == 0);
    CHECK(fw_range_profile_scratch(0) == 0);
    CHECK(fw_range_profile_scratch(100) == 128 * sizeof(float));
}

TEST_CASE("a range profile is the windowed Fourier sum in amplitude units", "[firmware]") {
    const auto config = GENERATE(all_bins(16, FW_WINDOW_RECT), all_bins(17, FW_WINDOW_RECT),
                                 all_bins(200, FW_WINDOW_RECT), all_bins(1000, FW_WINDOW_RECT),
                                 all_bins(1024, FW_WINDOW_RECT), all_bins(64, FW_WINDOW_HANN),
                                 all_bins(512, FW_WINDOW_HANN), all_bins(128, FW_WINDOW_BLACKMAN),
                                 all_bins(256, FW_WINDOW_BLACKMAN));
    const auto samples = oracle::random_codes(config.n_samples, 8);
    const auto amplitude = profile(samples, config);

    std::vector<std::complex<double>> windowed(fw_range_fft_size(config.n_samples));
    double sum = 0;
    for (std::size_t i = 0; i < config.n_samples; ++i) {
        const double w = oracle::window(config.window, i, config.n_samples);
        windowed[i] = w * samples[i];
        sum += w;
    }
    const auto truth = oracle::transform(windowed);
    // No bin is further off than all of them together: two roundings by the window, those of the
    // transform, and six by magnitude and scale.
    const double bound = (oracle::transform_error(windowed.size()) + 8 * oracle::unit_roundoff) *
                         oracle::norm(truth);
    for (std::size_t k = 0; k < config.n_bins; ++k) {
        CAPTURE(config.n_samples, config.window, k);
        CHECK(std::abs(amplitude[k] - std::abs(truth[k]) * 2 / sum) < bound * 2 / sum);
    }
}

TEST_CASE("a tone at the centre of a bin reads its amplitude", "[firmware]") {
    const auto window = GENERATE(FW_WINDOW_RECT, FW_WINDOW_HANN, FW_WINDOW_BLACKMAN);
    const auto n_samples = GENERATE(as<std::uint16_t>{}, 64, 128, 256, 512);
    const auto bin = GENERATE(as<std::uint16_t>{}, 6, 11, 17);
    const auto amplitude = profile(tone(n_samples, 30000, bin), all_bins(n_samples, window));
    // Rounding to codes is at most half an LSB per sample: at most 1 LSB of 2 / sum(w) sum(w e).
    // The tone's image at negative frequency, 2 bin away, leaks through the window.
    CHECK(std::abs(amplitude[bin] - 30000) < 1 + 30000 * leakage(window, n_samples, 2 * bin));
    CHECK(std::max_element(amplitude.begin(), amplitude.end()) - amplitude.begin() == bin);
}

TEST_CASE("bin 0 reads twice the offset and nothing of the last bin", "[firmware]") {
    Codes samples(64);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = i % 2 == 0 ? 40 + 9 : 40 - 9;
    const auto amplitude = profile(samples, all_bins(64, FW_WINDOW_RECT));
    CHECK(amplitude[0] == 80.0F);
    CHECK(*std::max_element(amplitude.begin() + 1, amplitude.end()) == 0.0F);
}

TEST_CASE("leakage of a point target agrees with the closed form", "[firmware]") {
    // Written by an independent numpy program (point path, X = rfft(s w) 2 / sum(w), bins 4 to 20).
    std::ifstream file(SPECULA_SOURCE_DIR "/tests/reference/F01_range_bin.json");
    const auto reference = nlohmann::json::parse(file);
    const auto index = GENERATE(0, 1, 2, 3, 4);
    const auto& in = reference["points"][index]["inp"];
    const auto& expected = reference["points"][index]["expect"];

    constexpr double full_scale = 30000;
    const double delay_s = 2 * in["R_m"].get<double>() / 299792458.0;
    const double slope = expected["slope_hz_per_s"];
    const double start_hz = in["f0_hz"];
    const std::uint16_t n_samples = in["N"];
    Codes samples(n_samples);
    for (std::size_t i = 0; i < n_samples; ++i) {
        const double time_s = static_cast<double>(i) / in["fs_hz"].get<double>();
        const double turns =
            start_hz * delay_s + slope * delay_s * time_s - slope * delay_s * delay_s / 2;
        samples[i] = static_cast<std::int16_t>(
            std::lround(full_scale * std::cos(2 * std::numbers::pi * turns)));
    }

    const struct {
        fw_window window;
        const char* key;
    } cases[] = {{FW_WINDOW_RECT, "bins_4_to_20_db_rect"},
                 {FW_WINDOW_HANN, "bins_4_to_20_db_hann"},
                 {FW_WINDOW_BLACKMAN, "bins_4_to_20_db_blackman"}};
    for (const auto& [window, key] : cases) {
        const auto amplitude = profile(
            samples, {.n_samples = n_samples, .first_bin = 4, .n_bins = 17, .window = window});
        for (std::size_t k = 0; k < amplitude.size(); ++k) {
            CAPTURE(index, key, k + 4);
            const double truth = std::pow(10.0, expected[key][k].get<double>() / 20);
            // Codes are off by 0.29 LSB rms, evenly spread over 128 bins: an amplitude of
            // 2 * 0.29 / sqrt(256) * sqrt(1.73, Blackman's noise bandwidth) = 0.05 LSB rms per
            // bin. Five of those.
            CHECK(std::abs(amplitude[k] / full_scale - truth) < 0.25 / full_scale);
        }
    }
}

TEST_CASE("a few bins are the same bits as those of the whole spectrum", "[firmware]") {
    const auto samples = oracle::random_codes(128, 9);
    const auto whole = profile(samples, all_bins(128, FW_WINDOW_BLACKMAN));
    const auto part = profile(
        samples, {.n_samples = 128, .first_bin = 6, .n_bins = 12, .window = FW_WINDOW_BLACKMAN});
    CHECK(std::equal(part.begin(), part.end(), whole.begin() + 6));
}

TEST_CASE("a range profile that cannot be made leaves its output untouched", "[firmware]") {
    const fw_range_config good{
        .n_samples = 128, .first_bin = 6, .n_bins = 12, .window = FW_WINDOW_BLACKMAN};
    const auto samples = oracle::random_codes(1025, 10);
    std::vector<float> scratch(1025);
    const std::vector<float> before(512, -1.0F);
    auto out = before;
    const auto status = [&](fw_range_config config) {
        return fw_range_profile(samples.data(), &config, scratch.data(), 4100, out.data());
    };
    const auto with = [&](auto member, auto value) {
        auto config = good;
        config.*member = value;
        return config;
    };
    CHECK(status(with(&fw_range_config::n_samples, 15)) == FW_ERR_SHAPE);
    CHECK(status(with(&fw_range_config::n_samples, 1025)) == FW_ERR_SHAPE);
    CHECK(status(with(&fw_range_config::n_samples, 100)) == FW_ERR_SHAPE);  // not tabulated
    CHECK(status(with(&fw_range_config::window, static_cast<fw_window>(3))) == FW_ERR_CONFIG);
    CHECK(status(with(&fw_range_config::n_bins, 0)) == FW_ERR_CONFIG);
    CHECK(status(with(&fw_range_config::n_bins, 59)) == FW_ERR_CONFIG);
    CHECK(status(with(&fw_range_config::first_bin, 53)) == FW_ERR_CONFIG);
    CHECK(status(with(&fw_range_config::first_bin, 65535)) == FW_ERR_CONFIG);

    const auto* row = samples.data();
    auto* lent = scratch.data();
    const auto bytes = fw_range_profile_scratch(128);
    CHECK(fw_range_profile(row, &good, lent, bytes - 1, out.data()) == FW_ERR_SCRATCH);
    auto* misaligned = reinterpret_cast<char*>(lent) + 2;
    CHECK(fw_range_profile(row, &good, misaligned, bytes, out.data()) == FW_ERR_SCRATCH);
    CHECK(fw_range_profile(nullptr, &good, lent, bytes, out.data()) == FW_ERR_NULL);
    CHECK(fw_range_profile(row, nullptr, lent, bytes, out.data()) == FW_ERR_NULL);
    CHECK(fw_range_profile(row, &good, nullptr, bytes, out.data()) == FW_ERR_NULL);
    CHECK(fw_range_profile(row, &good, lent, bytes, nullptr) == FW_ERR_NULL);
    CHECK(out == before);
}
