#include "scenes/ti_config.hpp"

#include <cstdlib>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

const std::filesystem::path board = SPECULA_SOURCE_DIR "/scenes/radars/iwrl6432boost.toml";

// Chirp B, TDM with both TX, as a demo would be given it.
const std::string demo = R"(% a demo
sensorStop 0
channelCfg 7 3 0
chirpComnCfg 20 0 0 128 1 33 0
chirpTimingCfg 6 28 0 150 57.5   % MHz/us, GHz
frameCfg 2 0 403 1 100 0
antGeometryCfg 0 0 1 1 0 2 0 1 1 2 0 3 2.5 2.6
factoryCalibCfg 1 0 38 4 0x1ff000
clutterRemoval 0
adcDataSource 0 adc_test_data.bin
sensorStart 0 0 0 0
)";

Radar radar_in(const std::string& text) {
    const MadeUpFolder folder;
    return read_ti_config(folder.with("my.cfg", text), board);
}

/// The message from the file's name on.
std::string config_error(const std::string& from, const std::string& to) {
    const std::string message = message_of([&] { return radar_in(edited(demo, from, to)); });
    const auto at = message.find("my.cfg");
    return at == std::string::npos ? message : message.substr(at);
}

TEST_CASE("a TI command file sets up chirp, channels, frame and gain", "[ti_config]") {
    const Radar radar = radar_in(demo);
    CHECK(radar.name == "my");
    CHECK(radar.warnings.empty());
    CHECK(radar.chirp.sample_rate_hz == 5e6);
    CHECK(radar.chirp.n_samples == 128);
    CHECK(radar.chirp.skip_samples == 28);
    CHECK(radar.chirp.start_hz == Approx(57.5e9));
    CHECK(radar.chirp.slope_hz_s == Approx(150e12));
    CHECK(radar.chirp.ramp_end_s == Approx(33e-6));
    CHECK(radar.chirp.idle_s == Approx(6e-6));
    CHECK(radar.receiver.high_pass_hz == 175e3);
    CHECK(radar.receiver.gain_db == 38.0);
    CHECK(radar.tx_power_dbm == Approx(11.0 - 4.0));
    CHECK(radar.n_tx() == 2);
    CHECK(radar.multiplexing == Multiplexing::tdm);
    CHECK(radar.chirps_per_frame == 2);
    CHECK(radar.tx(1).inverted);
    // Columns of 2.5 mm, rows of 2.6 mm, from the first antenna.
    CHECK((radar.rx[1].position_m - radar.rx[0].position_m - Vector3(2.5e-3, 2.6e-3, 0)).norm() <
          1e-12);
    CHECK((radar.tx(1).position_m - radar.tx(0).position_m - Vector3(2.5e-3, 0, 0)).norm() < 1e-12);
    // Less power, less leakage.
    CHECK(radar.leakage.front().level_dbm ==
          Approx(read_radar(board).leakage.front().level_dbm - 4));
}

TEST_CASE("the bins of TI's own configurations come out as published", "[ti_config]") {
    // Bin widths and the bin of 45 cm, computed elsewhere from the chip's LSBs and rounded.
    struct Known {
        const char* common;
        const char* timing;
        double bin_cm;
        double bin_of_45cm;
    };
    for (const Known& known : {Known{"20 0 0 128 1 30 0", "6 28 0 90 59.75", 6.51, 6.9},
                               Known{"8 0 0 256 4 23 2", "6 24 0 75 60.5", 9.76, 4.6},
                               Known{"8 0 0 256 4 24.3 3", "28 37 0 160 58", 4.58, 9.8},
                               Known{"25 0 0 256 1 70 0", "6 4 0 100 57", 2.34, 19.2}}) {
        INFO(known.common << " / " << known.timing);
        const Radar radar = radar_in(edited(edited(demo, "20 0 0 128 1 33 0", known.common),
                                            "6 28 0 150 57.5", known.timing));
        CHECK(radar.chirp.bin_m() * 100.0 == Approx(known.bin_cm).margin(0.01));
        CHECK(radar.chirp.bin_of(0.45) == Approx(known.bin_of_45cm).margin(0.05));
    }
}

TEST_CASE("high-pass codes and MIMO patterns are those of the chip", "[ti_config]") {
    const double corners_hz[] = {175e3, 350e3, 700e3, 1400e3};
    for (int code = 0; code < 4; ++code)
        CHECK(radar_in(edited(demo, "128 1 33 0", "128 1 33 " + std::to_string(code)))
                  .receiver.high_pass_hz == corners_hz[code]);
    CHECK(radar_in(edited(demo, "128 1 33 0", "128 4 33 0")).multiplexing == Multiplexing::bpm);
}

TEST_CASE("channel masks take antennas away with their leakage", "[ti_config]") {
    const Radar one = radar_in(edited(demo, "channelCfg 7 3 0", "channelCfg 4 1 0"));
    REQUIRE(one.rx.size() == 1);
    CHECK(one.n_tx() == 1);
    CHECK(one.leakage.size() == 1);
    CHECK(one.leakage.front().rx == 0);
    CHECK(one.leakage.front().range_m == Approx(42e-3));  // that of RX 2
    // The second TX alone is its own reference, so it is upright.
    const Radar second = radar_in(edited(demo, "channelCfg 7 3 0", "channelCfg 7 2 0"));
    CHECK(second.n_tx() == 1);
    CHECK_FALSE(second.tx(0).inverted);
}

TEST_CASE("unknown commands and other numbers of arguments warn, with their line", "[ti_config]") {
    const auto warnings = radar_in(edited(demo, "clutterRemoval 0", "cluterRemoval 0")).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("my.cfg:9: cluterRemoval: is not known and has no effect; did you mean "
                           "clutterRemoval?") != std::string::npos);
    const auto counts = radar_in(edited(demo, "sensorStart 0 0 0 0", "sensorStart")).warnings;
    REQUIRE(counts.size() == 1);
    CHECK(counts[0].find("my.cfg:11: sensorStart: has 0 arguments; usual are 4") !=
          std::string::npos);
    const auto removal = radar_in(edited(demo, "clutterRemoval 0", "clutterRemoval 1")).warnings;
    REQUIRE(removal.size() == 1);
    CHECK(removal[0].find("takes standing echoes out") != std::string::npos);
}

TEST_CASE("wrong types and impossible chirps are errors with the line", "[ti_config]") {
    CHECK(config_error("6 28 0 150 57.5", "6 28 0 fast 57.5") ==
          "my.cfg:5: chirpTimingCfg argument 4 = fast: is not a number; give a number");
    CHECK(
        config_error("6 28 0 150 57.5", "6 28.5 0 150 57.5") ==
        "my.cfg:5: chirpTimingCfg chirpAdcSkipSamples = 28.5: is not a whole number; give a whole "
        "number");
    CHECK(
        config_error("6 28 0 150 57.5", "6 28 0 150 60") ==
        "my.cfg:5: chirpTimingCfg chirpRfFreqStart = 60: the ramp runs from 60 to 64.95 GHz, and "
        "the IWRL6432 has 57 to 64 GHz; move the start, lessen the slope or end the ramp earlier");
    CHECK(config_error("20 0 0 128 1 33 0", "7 0 0 128 1 33 0")
              .find("chirpComnCfg digOutputSampRate = 7: the IWRL6432 samples at 1 to 12.5 MHz") !=
          std::string::npos);
    CHECK(config_error("20 0 0 128 1 33 0", "20 0 0 100 1 33 0").find("is no power of two") !=
          std::string::npos);
    CHECK(config_error("20 0 0 128 1 33 0", "20 0 0 128 1 20 0").find("beyond the ramp's end") !=
          std::string::npos);
    CHECK(config_error("20 0 0 128 1 33 0", "20 0 0 128 1 33 4").find("codes 0 to 3") !=
          std::string::npos);
    CHECK(config_error("20 0 0 128 1 33 0", "20 0 0 nan 1 33 0").find("is not a number") !=
          std::string::npos);
    CHECK(config_error("38 4 0x1ff000", "60 4 0x1ff000").find("gains of 30 to 40 dB") !=
          std::string::npos);
    CHECK(config_error("frameCfg 2 0 403 1", "frameCfg 3 0 403 1").find("each of 2 TX") !=
          std::string::npos);
    CHECK(config_error("6 28 0 150 57.5", "6 28 40 150 57.5")
              .find("chirpTimingCfg chirpTxStartTime = 40: the TX would start to send at 40 us") !=
          std::string::npos);
    CHECK(config_error("frameCfg 2 0 403 1", "frameCfg 64 0 300 2")
              .find("burstPeriodicity = 300: is shorter than its 64 chirps, 2496 us") !=
          std::string::npos);
    CHECK(config_error("frameCfg 2 0 403 1 100 0", "frameCfg 2 0 403 1 0.4 0")
              .find("framePeriodicity = 0.4: is shorter than its 1 bursts, 0.403 ms") !=
          std::string::npos);
    CHECK(config_error("channelCfg 7 3 0", "channelCfg 8 3 0").find("mask of 1 to 7") !=
          std::string::npos);
    CHECK(config_error("chirpComnCfg 20 0 0 128 1 33 0\n", "").find("chirpComnCfg: is missing") !=
          std::string::npos);
    CHECK(message_of([] { return read_ti_config("nowhere.cfg", board); }).find("no such file") !=
          std::string::npos);
}

TEST_CASE("a byte order mark is no command, and a pitch of metres warns", "[ti_config]") {
    CHECK(radar_in("\xEF\xBB\xBF" + demo).warnings.empty());
    const auto warnings = radar_in(edited(demo, "2.5 2.6", "2500 2.6")).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("the pitch is in mm") != std::string::npos);
}

TEST_CASE("garbage is refused or warned about, never taken", "[ti_config]") {
    for (const char* text : {"", "\n\n%\n", "\x01\xff\x00 5\n", "chirpComnCfg\nchirpTimingCfg\n"})
        (void)message_of([&] { return radar_in(text); });  // InputError or a radar, nothing else
    CHECK(message_of([&] { return radar_in(""); }).find("chirpComnCfg: is missing") !=
          std::string::npos);
}

TEST_CASE("the configurations of the public recordings read", "[ti_config][captures]") {
    const char* folder = std::getenv("SPECULA_CAPTURES");
    if (folder == nullptr) {
        WARN("skipped: set SPECULA_CAPTURES to the folder of recordings");
        return;
    }
    for (const char* name : {"iwrl6432", "iwrl6432_2", "iwrl6432_default"}) {
        INFO(name);
        const Radar radar = read_ti_config(
            std::filesystem::path(folder) / "iwrl6432_adc" / (std::string(name) + ".cfg"), board);
        CHECK(radar.rx.size() == 3);
        CHECK(radar.chirp.bin_m() ==
              Approx(std::string(name) == "iwrl6432_2" ? 0.02342 : 0.0651).epsilon(1e-3));
    }
}

}  // namespace
}  // namespace specula
