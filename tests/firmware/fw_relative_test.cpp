#include "firmware/fw_relative.h"

#include <array>
#include <complex>

#include "tests/check.hpp"
#include "tests/firmware/oracle.hpp"

namespace {

using Complex = std::complex<double>;

constexpr std::uint16_t n_samples = 128;
constexpr fw_relative_config usual{.search_first = 5,
                                   .n_search = 18,
                                   .n_around = 12,
                                   .window = FW_WINDOW_BLACKMAN,
                                   .target_bin = 11.5F,
                                   .floor_lsb = 0.1F};

/// Rows of one tone: its place in bins, its amplitude, its phase.
struct Tone {
    double bin = 11.5, amplitude = 800.0, phase_rad = 0.3;
};

std::vector<std::int16_t> samples_of(const std::vector<Tone>& tones) {
    std::vector<std::int16_t> samples;
    for (int i = 0; i < n_samples; ++i) {
        double value = 0.0;
        for (const Tone& tone : tones)
            value += tone.amplitude *
                     std::cos(2.0 * std::numbers::pi * tone.bin * i / n_samples + tone.phase_rad);
        samples.push_back(static_cast<std::int16_t>(std::lround(value)));
    }
    return samples;
}

fw_frame frame_of(const std::vector<std::int16_t>& samples) {
    return {samples.data(), 1, static_cast<std::uint16_t>(samples.size() / n_samples), n_samples};
}

std::vector<float> described(const std::vector<std::int16_t>& samples,
                             const fw_relative_config& config = usual) {
    const fw_frame frame = frame_of(samples);
    std::vector<float> scratch(fw_relative_scratch(&frame) / sizeof(float));
    std::vector<float> out(fw_relative_features(&config));
    REQUIRE(fw_relative(&frame, &config, scratch.data(), scratch.size() * sizeof(float),
                        out.data()) == FW_OK);
    return out;
}

/// The windowed sum at any place, in double and without a transform.
Complex sum_at(const std::vector<std::int16_t>& samples, double bin) {
    fw_window_shape window{};
    REQUIRE(fw_window_find(FW_WINDOW_BLACKMAN, n_samples, &window) == FW_OK);
    Complex sum = 0.0;
    for (int i = 0; i < n_samples; ++i) {
        const double weight = static_cast<double>(window.half[std::min(i, n_samples - 1 - i)]);
        sum += weight * static_cast<double>(samples[static_cast<std::size_t>(i)]) *
               std::polar(1.0, -2.0 * std::numbers::pi * bin * i / n_samples);
    }
    return sum;
}

}  // namespace

TEST_CASE("the relative shape is the spectrum about the peak, over the peak", "[firmware]") {
    for (const double place : {8.4, 11.0, 11.5, 13.8}) {
        const auto samples = samples_of({{place, 800.0, 0.7}, {place + 2.3, 90.0, 1.9}});
        const auto out = described(samples);
        // The peak lies within a tenth of a bin of the strong tone.
        double peak = place;
        for (double at = place - 0.3; at < place + 0.3; at += 0.001)
            if (std::abs(sum_at(samples, at)) > std::abs(sum_at(samples, peak))) peak = at;
        const Complex top = sum_at(samples, peak);
        for (int k = -6; k < 6; ++k) {
            INFO(place << " " << k);
            // The sign that takes the turning out of whole bins is worked out for the peak's own
            // place here: exp(j pi k) of a shift by k bins.
            const Complex expected =
                sum_at(samples, peak + k) / top * std::polar(1.0, std::numbers::pi * k);
            const auto i = static_cast<std::size_t>(2 * (k + 6));
            // Worked out in double apart from the code: the cubic through a Blackman lobe and the
            // parabola, which misplaces these peaks by up to 0.04 bins, miss by up to 0.074.
            CHECK(std::abs(static_cast<double>(out[i]) - expected.real()) < 0.09);
            CHECK(std::abs(static_cast<double>(out[i + 1]) - expected.imag()) < 0.09);
        }
        fw_window_shape window{};
        REQUIRE(fw_window_find(FW_WINDOW_BLACKMAN, n_samples, &window) == FW_OK);
        const double level =
            std::log(std::abs(top) * 2.0 / static_cast<double>(window.sum) * peak / 11.5);
        CHECK(static_cast<double>(out.back()) ==
              Approx(level).margin(0.06));  // nepers; 0.047 likewise
    }
}

TEST_CASE("gain and phase of the echo change no shape, gain the level alone", "[firmware]") {
    const auto reference = described(samples_of({{11.2, 400.0, 0.0}, {13.0, 60.0, 0.0}}));
    const auto turned = described(samples_of({{11.2, 400.0, 1.1}, {13.0, 60.0, 1.1}}));
    const auto louder = described(samples_of({{11.2, 1600.0, 0.0}, {13.0, 240.0, 0.0}}));
    for (std::size_t i = 0; i + 1 < reference.size(); ++i) {
        // Rounding to codes and the image of the negative frequencies: 0.0003, worked out apart
        // from the code.
        CHECK(static_cast<double>(turned[i]) == Approx(reference[i]).margin(1e-3));
        CHECK(static_cast<double>(louder[i]) == Approx(reference[i]).margin(1e-3));
    }
    CHECK(static_cast<double>(louder.back() - reference.back()) ==
          Approx(std::log(4.0)).margin(2e-3));
}

TEST_CASE("receivers are averaged", "[firmware]") {
    const auto one = samples_of({{10.8, 500.0, 0.2}, {12.6, 80.0, 0.9}});
    const auto two = samples_of({{10.8, 700.0, 1.4}, {12.6, 20.0, 0.1}});
    std::vector<std::int16_t> both = one;
    both.insert(both.end(), two.begin(), two.end());
    const auto a = described(one), b = described(two), mean = described(both);
    for (std::size_t i = 0; i + 1 < mean.size(); ++i)
        CHECK(mean[i] == Approx(0.5F * (a[i] + b[i])).margin(1e-6));  // one rounding each
    // The level is the logarithm of the mean, not the mean of logarithms.
    CHECK(mean.back() ==
          Approx(std::log(0.5 * (std::exp(a.back()) + std::exp(b.back())))).margin(1e-5));
}

TEST_CASE("what cannot be described is refused and nothing is written", "[firmware]") {
    const auto samples = samples_of({{}});
    const fw_frame frame = frame_of(samples);
    std::vector<float> scratch(fw_relative_scratch(&frame) / sizeof(float));
    const std::size_t bytes = scratch.size() * sizeof(float);
    std::array<float, 25> out{};
    out.fill(7.0F);
    const auto status = [&](const fw_frame* of, const fw_relative_config* config) {
        return fw_relative(of, config, scratch.data(), bytes, out.data());
    };
    CHECK(status(nullptr, &usual) == FW_ERR_NULL);
    CHECK(status(&frame, nullptr) == FW_ERR_NULL);
    fw_relative_config wrong = usual;
    wrong.n_around = 0;
    CHECK(status(&frame, &wrong) == FW_ERR_CONFIG);
    wrong = usual;
    wrong.n_search = 60;  // bins 5 to 64 of 64
    CHECK(status(&frame, &wrong) == FW_ERR_CONFIG);
    wrong = usual;
    wrong.target_bin = 0.0F;
    CHECK(status(&frame, &wrong) == FW_ERR_CONFIG);
    wrong.target_bin = 1e-38F;  // the level is then beyond the range of float
    CHECK(fw_relative_check(&frame, &wrong) == FW_OK);
    CHECK(status(&frame, &wrong) == FW_ERR_NONFINITE);
    fw_frame odd = frame;
    odd.n_samples = 96;
    CHECK(fw_relative_scratch(&odd) == 0);
    CHECK(status(&odd, &usual) == FW_ERR_SHAPE);
    CHECK(fw_relative_check(&odd, &usual) == FW_ERR_SHAPE);
    CHECK(fw_relative_check(nullptr, &usual) == FW_ERR_NULL);
    CHECK(fw_relative(&frame, &usual, scratch.data(), bytes - 1, out.data()) == FW_ERR_SCRATCH);
    const std::vector<std::int16_t> silence(n_samples, 0);
    const fw_frame silent = frame_of(silence);
    CHECK(status(&silent, &usual) == FW_ERR_NONFINITE);
    for (const float value : out) CHECK(value == 7.0F);
}
