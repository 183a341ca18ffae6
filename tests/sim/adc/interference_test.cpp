#include "sim/adc/interference.hpp"

#include "sim/core/constants.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

constexpr double amplitude = 100.0;

std::vector<std::complex<double>> beat_with(const Radar& radar, const Interferer& other,
                                            double lead_s) {
    std::vector<std::complex<double>> beat(145);
    Stream stream({.seed = 7, .purpose = "interferer"});
    Interference(radar, other).add(beat, {.lead_s = lead_s, .amplitude = amplitude}, stream);
    return beat;
}

TEST_CASE("a ramp of the same slope beats at a constant difference", "[adc]") {
    const Radar radar;
    Interferer other{.start_hz = radar.chirp.start_hz - 1e6,
                     .slope_hz_s = radar.chirp.slope_hz_s,
                     .ramp_s = 50e-6,
                     .period_s = 60e-6};
    const auto beat = beat_with(radar, other, 0.0);
    for (std::size_t i = 1; i < beat.size(); ++i) {
        CHECK(std::abs(beat[i]) == Approx(amplitude));
        CHECK(std::arg(beat[i] * std::conj(beat[i - 1])) == Approx(two_pi * 1e6 / 5e6));
    }
}

TEST_CASE("a crossing ramp is heard while it lies within the IF band", "[adc]") {
    const Radar radar;
    // Falls as fast as ours rises and meets it in the middle of 30 us: 300 MHz/us between them.
    Interferer other{.start_hz = radar.chirp.start_hz + 150e12 * 30e-6,
                     .slope_hz_s = -150e12,
                     .ramp_s = 50e-6,
                     .period_s = 60e-6};
    const auto beat = beat_with(radar, other, 0.0);
    std::size_t heard = 0;
    for (std::size_t i = 0; i < beat.size(); ++i) {
        const double apart_s = std::abs(static_cast<double>(i) / 5e6 - 15e-6);
        if (apart_s * 300e12 > 2.5e6) CHECK(std::abs(beat[i]) == 0.0);
        if (std::abs(beat[i]) > 0.0) ++heard;
    }
    // +-2.5 MHz at 300 MHz/us last 17 ns, less than a sample: one at most.
    CHECK(heard == 1);
}

TEST_CASE("between its ramps the other radar is silent", "[adc]") {
    const Radar radar;
    Interferer other{.start_hz = radar.chirp.start_hz,
                     .slope_hz_s = radar.chirp.slope_hz_s,
                     .ramp_s = 10e-6,
                     .period_s = 100e-6};
    for (const auto& sample : beat_with(radar, other, 20e-6)) CHECK(std::abs(sample) == 0.0);
    CHECK(std::abs(beat_with(radar, other, 0.0).front()) > 0.0);
}

}  // namespace
}  // namespace specula
