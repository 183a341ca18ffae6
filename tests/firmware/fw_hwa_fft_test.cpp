#include "firmware/fw_hwa_fft.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

#include "firmware/fw_range_profile.h"
#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

using Integers = std::vector<std::complex<double>>;  // integer-valued: doubles hold 53 bits

constexpr fw_hwa_config as_ti{.n_samples = 128,
                              .window = FW_WINDOW_BLACKMAN,
                              .scaled_stages = FW_HWA_DEFAULT_SCALED_STAGES,
                              .output_shift = FW_HWA_DEFAULT_OUTPUT_SHIFT};

struct Spectrum {
    std::vector<std::int16_t> im_re;
    std::uint32_t n_saturated = 0;

    std::complex<double> bin(std::size_t k) const {
        return {static_cast<double>(im_re[2 * k + 1]), static_cast<double>(im_re[2 * k])};
    }
};

Spectrum spectrum(const std::vector<std::int16_t>& samples, const fw_hwa_config& config) {
    const std::size_t bytes = fw_hwa_fft_scratch(config.n_samples);
    std::vector<std::int32_t> scratch(bytes / 4);
    Spectrum result;
    result.im_re.resize(fw_range_fft_size(config.n_samples));
    REQUIRE(fw_hwa_fft(samples.data(), &config, scratch.data(), bytes, result.im_re.data(),
                       &result.n_saturated) == FW_OK);
    return result;
}

double to_even(double x) {
    return std::nearbyint(x);
}  // the default rounding mode

std::complex<double> to_even(std::complex<double> z) {
    return {to_even(z.real()), to_even(z.imag())};
}

std::complex<double> clamp24(std::complex<double> z) {
    const auto part = [](double x) { return std::clamp(x, -8388608.0, 8388607.0); };
    return {part(z.real()), part(z.imag())};
}

/// The same rules said recursively: halves of a transform are transforms of the even and odd
/// places.
Integers plainly(const Integers& x, const fw_hwa_config& config, unsigned stages_after) {
    const std::size_t n = x.size();
    if (n == 1) return x;
    Integers even, odd;
    for (std::size_t i = 0; i < n; ++i) (i % 2 == 0 ? even : odd).push_back(x[i]);
    even = plainly(even, config, stages_after + 1);
    odd = plainly(odd, config, stages_after + 1);
    Integers out(n);
    const bool halved = (config.scaled_stages >> stages_after & 1) != 0;
    for (std::size_t k = 0; k < n / 2; ++k) {
        const double angle =
            -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
        const double one = 1 << 20;
        // Factors are those of the float table (fw_tables_test), brought to Q20.
        const auto factor = [one](double value) {
            return std::round(static_cast<float>(value) * one);
        };
        const double re = factor(std::cos(angle)), im = factor(std::sin(angle));
        const auto turned =
            to_even(std::complex<double>((re * odd[k].real() - im * odd[k].imag()) / one,
                                         (re * odd[k].imag() + im * odd[k].real()) / one));
        out[k] = even[k] + turned;
        out[k + n / 2] = even[k] - turned;
        for (auto* z : {&out[k], &out[k + n / 2]}) *z = clamp24(halved ? to_even(*z / 2.0) : *z);
    }
    return out;
}

Integers windowed(const std::vector<std::int16_t>& samples, const fw_hwa_config& config) {
    Integers x(fw_range_fft_size(config.n_samples));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double weight =
            std::round(static_cast<float>(oracle::window(config.window, i, samples.size())) *
                       131072.0);  // Q17
        x[i] = to_even(samples[i] * weight / (1 << 17));
    }
    return x;
}

std::vector<std::int16_t> quiet_codes(std::size_t n, int size, unsigned seed) {
    auto codes = oracle::random_codes(n, seed);
    for (auto& code : codes) code = static_cast<std::int16_t>(code * size / 32768);
    return codes;
}

}  // namespace

TEST_CASE("the HWA-like transform follows its rules to the last bit", "[firmware]") {
    const auto window = GENERATE(FW_WINDOW_RECT, FW_WINDOW_BLACKMAN);
    const auto n = GENERATE(as<std::uint16_t>{}, 64, 128, 512);
    const auto stages = GENERATE(as<std::uint16_t>{}, 0, 1, 5, 63);
    const fw_hwa_config config{n, window, stages, 2};
    for (unsigned seed = 0; seed < 3; ++seed) {
        const auto samples = oracle::random_codes(n, seed);
        const auto expected = plainly(windowed(samples, config), config, 0);
        const auto found = spectrum(samples, config);
        bool same = true;
        for (std::size_t k = 0; k < n / 2U; ++k) {
            const auto divided = to_even(expected[k] / 4.0);
            same = same && found.bin(k) ==
                               std::complex<double>(std::clamp(divided.real(), -32768.0, 32767.0),
                                                    std::clamp(divided.imag(), -32768.0, 32767.0));
        }
        CHECK(same);
    }
}

TEST_CASE("whatever the level, the HWA-like transform is within 4 counts of the exact one",
          "[firmware]") {
    // Sixteen-fold steps from quieter than the converter's noise to its full scale. Rounding, as a
    // variance: of the window 128/12; of the products 1/6 each, of which 16 + 8 + 4 + 2 + 1 that
    // are not trivial feed a bin, three quarters of them; both over 4^2; of the output 1/6. The
    // root is 1.04 counts. The largest of 3840 Rayleigh values is about sqrt(ln 3840) = 2.9 times
    // that.
    const auto size = GENERATE(8, 128, 2047);
    double squares = 0, largest = 0, count = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto samples = quiet_codes(128, size, 100 + seed);
        std::vector<std::complex<double>> exact(128);
        for (std::size_t i = 0; i < 128; ++i)
            exact[i] = samples[i] * oracle::window(FW_WINDOW_BLACKMAN, i, 128);
        exact = oracle::transform(exact);
        const auto found = spectrum(samples, as_ti);
        CHECK(found.n_saturated == 0);
        for (std::size_t k = 0; k < 64; ++k) {
            const double error = std::abs(found.bin(k) - exact[k] / 4.0);
            squares += error * error;
            largest = std::max(largest, error);
            count += 1;
        }
    }
    CAPTURE(size, largest, std::sqrt(squares / count));
    CHECK(std::sqrt(squares / count) < 1.1);
    CHECK(std::sqrt(squares / count) > 0.8);  // it does round; small codes are often exact
    CHECK(largest < 4.0);
}

TEST_CASE("a bin is imaginary part first, and a rising beat has a positive frequency",
          "[firmware]") {
    std::vector<std::int16_t> samples(128);
    for (std::size_t i = 0; i < 128; ++i) {
        const double angle = 2 * std::numbers::pi * 10 * static_cast<double>(i) / 128;
        samples[i] = static_cast<std::int16_t>(std::lround(1000 * std::sin(angle)));
    }
    const auto found = spectrum(samples, as_ti);
    // sin = (e^ja - e^-ja) / 2j: bin 10 is -j 1000 sum(w) / 2 / 4, and sum(w) = 0.42 * 127.
    CHECK(found.im_re[20] == Approx(-1000 * 0.42 * 127 / 8).epsilon(1e-3));
    CHECK(std::abs(found.im_re[21]) <= 2);
}

TEST_CASE("what leaves a limit is counted, and saturates instead of wrapping", "[firmware]") {
    const std::vector<std::int16_t> loud(512, 32767);
    fw_hwa_config config{512, FW_WINDOW_RECT, 0, 2};
    auto found = spectrum(loud, config);  // bin 0 sums to 2^24, beyond 24 bits
    CHECK(found.n_saturated == 2);        // in the last stage and at the output
    CHECK(found.bin(0).real() == 32767);
    config.scaled_stages = 511;  // every stage halved: the mean
    config.output_shift = 0;
    found = spectrum(loud, config);
    CHECK(found.n_saturated == 0);
    CHECK(found.bin(0) == std::complex<double>(32767));
}

TEST_CASE("the HWA-like transform works in place and refuses what it cannot do", "[firmware]") {
    const auto samples = oracle::random_codes(128, 3);
    const auto expected = spectrum(samples, as_ti).im_re;
    std::vector<std::int32_t> scratch(256);
    auto* inside = reinterpret_cast<std::int16_t*>(scratch.data());
    REQUIRE(fw_hwa_fft(samples.data(), &as_ti, scratch.data(), 1024, inside, nullptr) == FW_OK);
    CHECK(std::vector<std::int16_t>(inside, inside + 128) == expected);

    std::vector<std::int16_t> out(128, 7);
    const auto status = [&](fw_hwa_config config, std::size_t bytes) {
        return fw_hwa_fft(samples.data(), &config, scratch.data(), bytes, out.data(), nullptr);
    };
    CHECK(status(as_ti, 1023) == FW_ERR_SCRATCH);
    CHECK(status({128, static_cast<fw_window>(9), 0, 2}, 1024) == FW_ERR_CONFIG);
    CHECK(status({128, FW_WINDOW_HANN, 128, 2}, 1024) == FW_ERR_CONFIG);
    CHECK(status({128, FW_WINDOW_HANN, 0, 9}, 1024) == FW_ERR_CONFIG);
    CHECK(status({100, FW_WINDOW_HANN, 0, 2}, 1024) == FW_ERR_SHAPE);
    CHECK(fw_hwa_fft(nullptr, &as_ti, scratch.data(), 1024, out.data(), nullptr) == FW_ERR_NULL);
    CHECK(out == std::vector<std::int16_t>(128, 7));
    CHECK(fw_hwa_fft_scratch(15) == 0);
}
