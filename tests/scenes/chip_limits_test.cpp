#include "scenes/chip_limits.hpp"

#include "scenes/radar.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/scenes/boost_file.hpp"

namespace specula {
namespace {

TEST_CASE("a chirp that the chip cannot make is refused, naming its limit", "[radar][limits]") {
    CHECK(error_with("start_ghz        = 57.5", "start_ghz = 60") ==
          "chirp.start_ghz = 60: the ramp runs from 60 to 64.95 GHz, and the IWRL6432 has 57 to "
          "64 GHz; move the start, lessen the slope or end the ramp earlier");
    CHECK(error_with("start_ghz        = 57.5", "start_ghz = 56.9").find("57 to 64 GHz") !=
          std::string::npos);
    CHECK(error_with("slope_mhz_per_us = 150", "slope_mhz_per_us = 180") == "(no error)");
    CHECK(
        error_with("sample_rate_mhz  = 5 ", "sample_rate_mhz = 20 ") ==
        "chirp.sample_rate_mhz = 20: the IWRL6432 samples at 1 to 12.5 MHz; choose a rate between");
    CHECK(error_with("gain_db         = 40 ", "gain_db = 42 ") ==
          "receiver.gain_db = 42: the IWRL6432 has gains of 30 to 40 dB in steps of 2 dB; choose "
          "one of them");
    CHECK(error_with("gain_db         = 40 ", "gain_db = 35 ").find("steps of 2 dB") !=
          std::string::npos);
    CHECK(error_with("high_pass_khz   = 175 ", "high_pass_khz = 200 ") ==
          "receiver.high_pass_khz = 200: the IWRL6432 has corners of 175, 350, 700 or 1400 kHz; "
          "choose one of them");
    CHECK(error_with("adc_bits        = 12", "adc_bits = 12\nsampling = \"complex\"") ==
          "receiver.sampling = \"complex\": the IWRL6432 gives real samples only; leave the key "
          "out or change it");
}

TEST_CASE("a slope beyond the chip's is refused before the band is", "[radar][limits]") {
    Chirp chirp;
    chirp.slope_hz_s = 400e12;
    chirp.ramp_end_s = 10e-6;
    chirp.n_samples = 16;
    ChipLimits limits;
    limits.chip = "a chip";
    limits.slope_max_hz_s = 399e12;
    const auto breach = limit_breach(limits, chirp, {});
    REQUIRE(breach);
    CHECK(breach->setting == "slope");
    CHECK(breach->problem == "is steeper than a chip can sweep, 399 MHz/us");
}

TEST_CASE("what a file does not limit is not checked", "[radar][limits]") {
    Chirp chirp;
    chirp.start_hz = 1e9;
    chirp.n_samples = 1 << 20;
    CHECK_FALSE(limit_breach({}, chirp, {.gain_db = 99.0, .high_pass_hz = 1.0}));
}

TEST_CASE("the ends of an interval belong to it", "[radar][limits]") {
    ChipLimits limits;
    limits.gain_db = {30.0, 40.0};
    for (const double gain_db : {30.0, 40.0})
        CHECK_FALSE(limit_breach(limits, Chirp{}, {.gain_db = gain_db}));
    for (const double gain_db : {29.99, 40.01})
        CHECK(limit_breach(limits, Chirp{}, {.gain_db = gain_db}));
}

}  // namespace
}  // namespace specula
