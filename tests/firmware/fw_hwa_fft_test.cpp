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

struct HwaSpectrum {
    std::vector<std::int16_t> im_re;
    fw_hwa_saturation cut{};

    std::complex<double> bin(std::size_t k) const {
        return {static_cast<double>(im_re[2 * k + 1]), static_cast<double>(im_re[2 * k])};
    }
};

HwaSpectrum spectrum(const std::vector<std::int16_t>& samples, const fw_hwa_config& config) {
    const std::size_t bytes = fw_hwa_fft_scratch(config.n_samples);
    std::vector<std::int32_t> scratch(bytes / 4);
    HwaSpectrum result;
    result.im_re.resize(fw_range_fft_size(config.n_samples));
    REQUIRE(fw_hwa_fft(samples.data(), &config, scratch.data(), bytes, result.im_re.data(),
                       &result.cut) == FW_OK);
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

/// Errors in counts, over many bins.
struct ErrorSize {
    double rms = 0, largest = 0;
};

/// Against the definition in double, over rows of noise of codes within +-size.
ErrorSize error_over_noise(const fw_hwa_config& config, int size) {
    const std::size_t n = config.n_samples;
    ErrorSize error;
    double count = 0;
    for (unsigned seed = 0; seed < (n > 256 ? 3 : 20); ++seed) {
        const auto samples = quiet_codes(n, size, 100 + seed);
        std::vector<std::complex<double>> exact(n);
        for (std::size_t i = 0; i < n; ++i)
            exact[i] = samples[i] * oracle::window(config.window, i, n);
        exact = oracle::transform(exact);
        const auto found = spectrum(samples, config);
        CHECK(found.cut.in_stages + found.cut.at_output == 0);
        for (std::size_t k = 0; k < n / 2; ++k) {
            const double size_of_error = std::abs(found.bin(k) - exact[k] / 4.0);
            error.rms += size_of_error * size_of_error;
            error.largest = std::max(error.largest, size_of_error);
            count += 1;
        }
    }
    error.rms = std::sqrt(error.rms / count);
    return error;
}

/// What independent roundings add up to, in counts: 1/12 of a step squared in each sample that the
/// window weighs; 1/12 in either part of each product whose factor is not 1 or -j (a stage of half
/// size h has h - 2 of h such, n / 2h of its products feed a bin); the sum over 4^2, and 1/12 in
/// either part of the output.
double rounding_rms(std::size_t n, fw_window window) {
    double variance = window == FW_WINDOW_RECT ? 0.0 : static_cast<double>(n) / 12.0;
    for (std::size_t half = 4; half < n; half *= 2) {
        const auto h = static_cast<double>(half);
        variance += static_cast<double>(n) / (2.0 * h) * (h - 2.0) / h / 6.0;
    }
    return std::sqrt(variance / 16.0 + 1.0 / 6.0);
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

TEST_CASE(
    "below its limits the HWA-like transform errs by its roundings, at every length and level",
    "[firmware]") {
    // Sixteen-fold steps from quieter than the converter's noise to its full scale.
    const auto size = GENERATE(8, 128, 2047);
    const auto [n, window] = GENERATE(table<std::uint16_t, fw_window>({{64, FW_WINDOW_BLACKMAN},
                                                                       {128, FW_WINDOW_BLACKMAN},
                                                                       {256, FW_WINDOW_BLACKMAN},
                                                                       {512, FW_WINDOW_BLACKMAN},
                                                                       {1024, FW_WINDOW_RECT}}));
    const ErrorSize error = error_over_noise({n, window, 0, 2}, size);
    const double expected = rounding_rms(n, window);
    CAPTURE(n, size, error.rms, error.largest, expected);
    // Small codes are often exact, so they err less than the model, which takes all as rounded;
    // 10 % more than it are 5 standard deviations of the mean of 640 squares.
    CHECK(error.rms < 1.1 * expected);
    CHECK(error.rms > 0.7 * expected);
    // A Rayleigh value exceeds 4.3 times its rms once in 1e8; there are 10,240 at most.
    CHECK(error.largest < 4.3 * expected);
}

TEST_CASE("a tone saturates the HWA-like output from 262,144 / sum(w) LSB on, and is counted",
          "[firmware]") {
    // A * sum(w) / 8 counts at the centre of a bin against the 32,767 of int16; the amplitudes are
    // those of README.md. A tone at phase 0 is all in the real part.
    const auto [n, window, limit] =
        GENERATE(table<std::uint16_t, fw_window, int>({{256, FW_WINDOW_BLACKMAN, 2448},
                                                       {512, FW_WINDOW_BLACKMAN, 1221},
                                                       {1024, FW_WINDOW_RECT, 256}}));
    for (const int above : {-5, 5}) {
        const int amplitude = limit + above;
        std::vector<std::int16_t> samples(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * 20 * static_cast<double>(i) / n;
            samples[i] = static_cast<std::int16_t>(std::lround(amplitude * std::cos(angle)));
        }
        const auto found = spectrum(samples, {n, window, 0, 2});
        CAPTURE(n, amplitude, found.bin(20).real());
        CHECK(found.cut.in_stages == 0);
        CHECK((found.cut.at_output > 0) == (above > 0));
        CHECK((found.bin(20).real() == 32767) == (above > 0));
    }
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
    CHECK(found.cut.in_stages == 1);      // in the last stage
    CHECK(found.cut.at_output == 1);
    CHECK(found.bin(0).real() == 32767);
    config.scaled_stages = 511;  // every stage halved: the mean
    config.output_shift = 0;
    found = spectrum(loud, config);
    CHECK(found.cut.in_stages + found.cut.at_output == 0);
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
