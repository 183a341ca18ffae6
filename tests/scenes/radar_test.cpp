#include "scenes/radar.hpp"

#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/scenes/boost_file.hpp"

namespace specula {
namespace {

using namespace literals;

Radar boost() {
    return read_radar(SPECULA_SOURCE_DIR "/scenes/radars/iwrl6432boost.toml");
}

TEST_CASE("the board's file reads as its numbers say", "[radar]") {
    const Radar radar = boost();
    CHECK(radar.name == "iwrl6432boost");
    CHECK(radar.chirp.start_hz == 57.5_GHz);
    CHECK(radar.chirp.bandwidth_hz() == Approx(3.84_GHz));
    CHECK(radar.chirps_per_frame == 1);
    CHECK(radar.tx_power_dbm == 11.0);
    REQUIRE(radar.rx.size() == 3);
    // Pitch of half a wavelength at 62 GHz, all about 1 cm to the side of the transmitter.
    CHECK((radar.rx[1].position_m - radar.rx[0].position_m).x() == Approx(2.418_mm));
    CHECK((radar.rx[2].position_m - radar.rx[0].position_m).x() == Approx(2.0 * 2.418_mm));
    CHECK((radar.tx_position_m - radar.rx[0].position_m).norm() == Approx(9.582_mm));
    CHECK(radar.rx[1].inverted);
    CHECK_FALSE(radar.rx[0].inverted);
    CHECK(radar.receiver.adc_bits == 12);
    CHECK(radar.receiver.temperature_k == 290.0);
    CHECK(radar.receiver.high_pass_hz == Approx(175e3));
    for (const Leakage& leak : radar.leakage) {
        CHECK(leak.rx < 3);
        CHECK(leak.level_dbm < radar.tx_power_dbm);
        CHECK(leak.phase_rad == 0.0);
    }
    CHECK_FALSE(radar.title.empty());
    CHECK_FALSE(radar.source.empty());
}

TEST_CASE("a tone of full scale behind the gain just fills the ADC", "[radar]") {
    Radar radar = boost();
    CHECK(radar.adc_full_scale_lsb() == 2048.0);
    const double full_dbm = radar.receiver.full_scale_dbm - radar.receiver.gain_db;
    CHECK(radar.amplitude_lsb(full_dbm) == Approx(2048.0).epsilon(1e-14));
    CHECK(radar.amplitude_lsb(full_dbm - 20.0) == Approx(204.8).epsilon(1e-14));
    radar.receiver.adc_bits = 16;
    CHECK(radar.amplitude_lsb(full_dbm) == Approx(32768.0).epsilon(1e-14));
}

TEST_CASE("every radar of the catalogue reads and says where its numbers are from", "[radar]") {
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECULA_SOURCE_DIR "/scenes/radars")) {
        INFO(entry.path());
        const Radar radar = read_radar(entry.path());
        CHECK(radar.source.size() > 20);
        CHECK(radar.chirp.start_hz >= 57.0_GHz - 1.0);
    }
}

TEST_CASE("a radar that cannot be is refused at the key to change", "[radar]") {
    CHECK(error_with("adc_bits        = 12", "adc_bits = 17") ==
          "receiver.adc_bits = 17: is out of range; give a value at least 2 and at most 16");
    CHECK(error_with("rx = 2\n", "rx = 3\n") ==
          "leakage.rx = 3: is out of range; give a value at least 0 and at most 2");
    CHECK(error_with("pattern  = \"patch\"", "pattern = \"horn\"") ==
          "antenna.pattern = \"horn\": is not known; use \"isotropic\", \"patch\" or \"table\"");
    CHECK(error_with("power_dbm   = 11", "power_dbm = -inf")
              .rfind("transmitter.power_dbm = -inf: is not a finite number", 0) == 0);
    CHECK(error_with("high_pass_khz", "highpass_khz")
              .rfind("receiver.high_pass_khz: is missing; add it, or is it meant by highpass_khz "
                     "in line ",
                     0) == 0);
    CHECK(error_with("inverted      = true", "inverted = \"yes\"")
              .rfind("rx.inverted = \"yes\": is not true or false", 0) == 0);
    CHECK(error_with("position_mm = [-6.0, 0.0] ", "position_mm = [-6.0, 0.0, 1.0]")
              .find("give 2 numbers") != std::string::npos);
    CHECK(error_with("[receiver]", "[reciever]")
              .rfind("receiver: is missing; add it, or is it meant by reciever in line ", 0) == 0);
}

TEST_CASE("a radar has 1 to 16 receive channels", "[radar]") {
    const std::string head = boost_text.substr(0, boost_text.find("[[rx]]"));
    const auto read = [&](int n) {
        std::string text = head;
        for (int i = 0; i < n; ++i) text += "[[rx]]\nposition_mm = [1, 2]\n";
        const MadeUpFolder folder;
        const auto file = folder.with("x.toml", text);
        return message_of([&] { return read_radar(file); });
    };
    CHECK(read(1) == "(no error)");
    CHECK(read(16) == "(no error)");
    for (const int n : {0, 17})
        CHECK(read(n).find(std::to_string(n) + " receive channels; describe 1 to 16 of them, "
                                               "each as [[rx]]") != std::string::npos);
}

}  // namespace
}  // namespace specula
