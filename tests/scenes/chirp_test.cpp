#include "scenes/chirp.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

using namespace literals;

// The chirp of the IWRL6432BOOST: 57.5 GHz, 150 MHz/us, 5 MHz, 128 samples, 17 of them settling.
const Chirp boost_chirp;

constexpr double chirp_rounding = 1e-14;

TEST_CASE("the board's chirp sweeps 3.84 GHz in bins of 3.90 cm", "[chirp]") {
    CHECK(boost_chirp.bandwidth_hz() == Approx(150e12 * 128 / 5e6).epsilon(chirp_rounding));
    CHECK(boost_chirp.bandwidth_hz() == Approx(3.84_GHz).epsilon(chirp_rounding));
    CHECK(boost_chirp.bin_m() == Approx(3.90_cm).epsilon(2e-3));
    CHECK(boost_chirp.bin_m() ==
          Approx(speed_of_light_m_s / (2.0 * 3.84e9)).epsilon(chirp_rounding));
}

TEST_CASE("45 cm lie in bin 11.5 and beat at 450 kHz", "[chirp]") {
    CHECK(boost_chirp.bin_of(0.45) == Approx(11.5).epsilon(3e-3));
    CHECK(boost_chirp.beat_hz(0.45) == Approx(450e3).epsilon(1e-3));
    // Two ways to the same number: beats of one bin are a transform's spacing apart.
    CHECK(boost_chirp.beat_hz(boost_chirp.bin_m()) == Approx(5e6 / 128).epsilon(chirp_rounding));
    CHECK(boost_chirp.bin_of(0.45) ==
          Approx(boost_chirp.beat_hz(0.45) * 128 / 5e6).epsilon(chirp_rounding));
}

TEST_CASE("samples sit on the ramp: the first after settling, the centre in the middle",
          "[chirp]") {
    CHECK(boost_chirp.settle_samples() == 17);
    CHECK(boost_chirp.frequency_hz(-17) == 57.5_GHz);
    CHECK(boost_chirp.frequency_hz(0) ==
          Approx(57.5e9 + 150e12 * 17 / 5e6).epsilon(chirp_rounding));
    CHECK(boost_chirp.frequency_hz(128) - boost_chirp.frequency_hz(0) ==
          Approx(boost_chirp.bandwidth_hz()).epsilon(1e-9));  // a difference of 60 GHz numbers
    CHECK(boost_chirp.centre_hz() == Approx(boost_chirp.frequency_hz(64)).epsilon(chirp_rounding));
}

TEST_CASE("the farthest range beats at 0.45 of the sample rate", "[chirp]") {
    CHECK(boost_chirp.beat_hz(boost_chirp.max_range_m()) ==
          Approx(0.45 * 5e6).epsilon(chirp_rounding));
    CHECK(boost_chirp.bin_of(boost_chirp.max_range_m()) ==
          Approx(0.45 * 128).epsilon(chirp_rounding));
}

std::string with(const std::string& key, const std::string& value) {
    std::string text;
    for (const auto& [name, usual] :
         std::vector<std::pair<std::string, std::string>>{{"start_ghz", "57.5"},
                                                          {"slope_mhz_per_us", "150"},
                                                          {"sample_rate_mhz", "5"},
                                                          {"n_samples", "128"},
                                                          {"skip_samples", "28"},
                                                          {"filter_latency_samples", "11"},
                                                          {"pass_band", "0.45"},
                                                          {"ramp_end_us", "33"}})
        text += name + " = " + (name == key ? value : usual) + "\n";
    return text;
}

Chirp chirp_in(const std::string& text) {
    Section section = Section::parse(text, "x.toml");
    Chirp chirp = Chirp::read(section);
    section.finish();
    return chirp;
}

TEST_CASE("a chirp's section reads into SI", "[chirp]") {
    const Chirp chirp = chirp_in(with("", ""));
    CHECK(chirp.start_hz == 57.5e9);
    CHECK(chirp.slope_hz_s == 150e12);
    CHECK(chirp.sample_rate_hz == 5e6);
    CHECK(chirp.ramp_end_s == Approx(33e-6));
    CHECK(chirp.bandwidth_hz() == boost_chirp.bandwidth_hz());
}

TEST_CASE("a chirp that cannot be is refused at the key to change", "[chirp]") {
    const auto error = [](const std::string& key, const std::string& value) {
        return message_of([&] { return chirp_in(with(key, value)); });
    };
    CHECK(error("n_samples", "100") ==
          "x.toml:4: n_samples = 100: is not a power of two, so range bins would be padded ones; "
          "use 64, 128, 256 or 512");
    CHECK(error("n_samples", "2048") ==
          "x.toml:4: n_samples = 2048: is out of range; give a value at least 16 and at most 1024");
    CHECK(error("n_samples", "256") ==
          "x.toml:4: n_samples = 256: samples run to 54.6 us, beyond the ramp's end at 33 us; "
          "take fewer samples, skip fewer, or end the ramp later");
    CHECK(error("skip_samples", "4") == "(no error)");  // 7 samples of the filter starting up
    CHECK(error("pass_band", "0.5").find("is out of range") != std::string::npos);
    CHECK(error("slope_mhz_per_us", "0") ==
          "x.toml:2: slope_mhz_per_us = 0: is out of range; "
          "give a value at least 0.001 mhz_per_us and at most 1000 mhz_per_us");
    CHECK(error("slope_mhz_per_us", "-150").find("is out of range") != std::string::npos);
    CHECK(error("start_ghz", "0.5").find("at least 1 ghz and at most 300 ghz") !=
          std::string::npos);
    CHECK(error("ramp_end_us", "0").find("is out of range") != std::string::npos);
    CHECK(error("n_samples", "16") == "(no error)");
    CHECK(error("n_samples", "128.0").find("is not a whole number") != std::string::npos);
}

}  // namespace
}  // namespace specula
