#include "firmware/fw_fft.h"

#include <complex>
#include <cstdint>
#include <vector>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

using Spectrum = std::vector<std::complex<double>>;

/// (n, 2) floats as complex numbers.
Spectrum paired(const std::vector<float>& data) {
    Spectrum values;
    for (std::size_t i = 0; i < data.size(); i += 2) values.emplace_back(data[i], data[i + 1]);
    return values;
}

/// Bins 0..n/2 of what fw_fft_real leaves behind.
Spectrum unpacked(const std::vector<float>& data) {
    Spectrum bins = paired(data);
    bins[0] = data[0];
    bins.emplace_back(data[1]);
    return bins;
}

double relative_error(const Spectrum& found, const Spectrum& truth) {
    Spectrum error(truth.size());
    for (std::size_t k = 0; k < truth.size(); ++k) error[k] = found[k] - truth[k];
    return oracle::norm(error) / oracle::norm(truth);
}

}  // namespace

TEST_CASE("the complex transform is the Fourier sum, within its rounding bound", "[firmware]") {
    for (std::size_t n = 2; n <= FW_FFT_MAX; n *= 2) {
        CAPTURE(n);
        auto data = oracle::random_values(2 * n, 3);
        const auto truth = oracle::transform(paired(data));
        REQUIRE(fw_fft_complex(data.data(), static_cast<std::uint16_t>(n)) == FW_OK);
        CHECK(relative_error(paired(data), truth) < oracle::transform_error(n));
    }
}

TEST_CASE("the real transform is the Fourier sum, within its rounding bound", "[firmware]") {
    for (std::size_t n = 4; n <= FW_FFT_MAX; n *= 2) {
        CAPTURE(n);
        auto data = oracle::random_values(n, 4);
        auto truth = oracle::transform(Spectrum(data.begin(), data.end()));
        truth.resize(n / 2 + 1);  // the other bins mirror these
        REQUIRE(fw_fft_real(data.data(), static_cast<std::uint16_t>(n)) == FW_OK);
        CHECK(relative_error(unpacked(data), truth) < oracle::transform_error(n));
    }
}

TEST_CASE("an impulse at time zero has a flat spectrum, exactly", "[firmware]") {
    std::vector<float> data(64);
    data[0] = 3;
    REQUIRE(fw_fft_real(data.data(), 64) == FW_OK);
    for (const auto& bin : unpacked(data)) CHECK(bin == 3.0);
}

TEST_CASE("a constant lives in bin 0 alone and an alternation in bin n/2 alone", "[firmware]") {
    std::vector<float> data(128);
    for (std::size_t i = 0; i < data.size(); ++i) data[i] = i % 2 == 0 ? 5.0F + 2.0F : 5.0F - 2.0F;
    REQUIRE(fw_fft_real(data.data(), 128) == FW_OK);
    const auto bins = unpacked(data);  // small integers: float arithmetic is exact
    CHECK(bins[0] == 5.0 * 128);
    CHECK(bins[64] == 2.0 * 128);
    for (std::size_t k = 1; k < 64; ++k) CHECK(bins[k] == 0.0);
}

TEST_CASE("a size that is no power of two in range is refused and data stays", "[firmware]") {
    const auto before = oracle::random_values(2 * FW_FFT_MAX, 5);
    auto data = before;
    for (const std::uint16_t n : {0, 1, 3, 6, 48, 1000, 1023, 1025, 2048, 65535}) {
        CHECK(fw_fft_complex(data.data(), n) == FW_ERR_SHAPE);
        CHECK(fw_fft_real(data.data(), n) == FW_ERR_SHAPE);
    }
    CHECK(fw_fft_real(data.data(), 2) == FW_ERR_SHAPE);
    CHECK(data == before);
    CHECK(fw_fft_complex(nullptr, 16) == FW_ERR_NULL);
    CHECK(fw_fft_real(nullptr, 16) == FW_ERR_NULL);
}
