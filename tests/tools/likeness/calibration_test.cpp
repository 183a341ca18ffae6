#include "tools/likeness/calibration.hpp"

#include <cmath>

#include "sim/channel/path.hpp"
#include "sim/core/constants.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tools/likeness/likeness.hpp"

namespace specula {
namespace {

/// A board with everything that calibration finds, and its recording of `input`.
Radar leaky_board() {
    Radar radar = read_radar(SPECULA_SOURCE_DIR "/scenes/radars/iwrl6432boost.toml");
    radar.rx.resize(2);
    radar.rx[0] = {.dc_offset_lsb = 17.0};
    radar.rx[1] = {.position_m = {2e-3, 0, 0}, .inverted = true, .dc_offset_lsb = -42.0};
    radar.receiver.noise_figure_db = 15.0;
    radar.receiver.adc_noise_lsb = 0.7;
    radar.leakage = {{.rx = 0, .range_m = 0.060, .level_dbm = -25.0, .phase_rad = 0.7},
                     {.rx = 1, .range_m = 0.110, .level_dbm = -36.0, .phase_rad = -1.2}};
    return radar;
}

ChirpSeries record(const Radar& radar, const ReceiverInput& input, int n_chirps) {
    ChirpSeries series{static_cast<int>(radar.rx.size()), radar.chirp.n_samples, {}};
    const ReceiverChain chain(radar);
    for (int i = 0; i < n_chirps; ++i) {
        Stream noise({.seed = 9, .purpose = "thermal noise", .item = static_cast<unsigned>(i)});
        const AdcFrame frame = chain.receive(input, {}, noise);
        series.codes.insert(series.codes.end(), frame.codes.begin(), frame.codes.end());
    }
    return series;
}

ChirpSeries record_empty(const Radar& radar, int n_chirps) {
    const auto none = dechirp(
        silent_channel(static_cast<int>(radar.rx.size()), comb_of(radar.chirp)), radar.chirp);
    return record(radar, {none, dechirp(leakage_channel(radar, {}), radar.chirp)}, n_chirps);
}

/// The board as its user knows it: nothing of leakage, offsets and noise.
Radar unknowing(Radar radar) {
    radar.leakage.clear();
    for (ReceiveChannel& rx : radar.rx) rx.dc_offset_lsb = 0.0;
    radar.receiver.noise_figure_db = 12.0;
    radar.receiver.adc_noise_lsb = 0.0;
    return radar;
}

Complex wave_at(const Leakage& leak, const Radar& radar) {
    const double k = two_pi * radar.chirp.centre_hz() / speed_of_light_m_s;
    return std::polar(std::pow(10.0, leak.level_dbm / 20.0),
                      leak.phase_rad - 2.0 * k * leak.range_m);
}

TEST_CASE("calibration finds the board that an empty recording was made with", "[likeness]") {
    const Radar truth = leaky_board();
    const Calibration found = calibrate(record_empty(truth, 200), unknowing(truth), nullptr);
    // 200 chirps of 128 samples: the noise's power is known to 1 %, its parts trade against each
    // other, a few per cent each.
    CHECK(found.radar.receiver.noise_figure_db == Approx(15.0).margin(0.4));
    CHECK(found.radar.receiver.adc_noise_lsb == Approx(0.7).margin(0.07));
    for (std::size_t rx = 0; rx < 2; ++rx)
        CHECK(found.radar.rx[rx].dc_offset_lsb == Approx(truth.rx[rx].dc_offset_lsb).margin(0.15));
    REQUIRE(found.radar.leakage.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const Leakage &is = found.radar.leakage[i], &was = truth.leakage[i];
        CHECK(is.rx == was.rx);
        CHECK(is.range_m == Approx(was.range_m).margin(0.3e-3));
        CHECK(is.level_dbm == Approx(was.level_dbm).margin(0.1));
        const Complex off = wave_at(is, truth) / wave_at(was, truth);
        CHECK(std::abs(std::arg(off)) < 0.02);
    }
    for (const FittedChannel& channel : found.channels)
        CHECK(channel.residual_lsb < 0.15);  // noise of the mean, 1.1 / sqrt(200), and rounding
}

TEST_CASE("a known scene tells gain and phase of each receiver", "[likeness]") {
    Radar truth = leaky_board();
    const FrequencyComb comb = comb_of(truth.chirp);
    Channel channel = silent_channel(2, comb);
    for (int rx = 0; rx < 2; ++rx)
        add_path(channel, comb,
                 {.rx = rx, .length_m = 0.9 + 1e-3 * rx, .transfer = Complex(0.0, 4e-4)});
    const BeatSignal echo = dechirp(channel, truth.chirp);
    truth.rx[0].gain_db = -1.5;
    truth.rx[0].phase_rad = 0.4;
    const auto still = dechirp(leakage_channel(truth, {}), truth.chirp);
    Radar known = unknowing(truth);
    known.rx[0].gain_db = known.rx[0].phase_rad = 0.0;
    const Calibration found = calibrate(record(truth, {echo, still}, 100), known, &echo);
    CHECK(found.radar.rx[0].gain_db == Approx(-1.5).margin(0.05));
    CHECK(found.radar.rx[0].phase_rad == Approx(0.4).margin(0.01));
    CHECK(found.radar.rx[1].gain_db == Approx(0.0).margin(0.05));
    CHECK(std::abs(found.radar.rx[1].phase_rad) == Approx(pi).margin(0.01));  // its inversion
    // The same codes come out of the calibrated board.
    const auto again = dechirp(leakage_channel(found.radar, {}), truth.chirp);
    const ChirpSeries was = record(truth, {echo, still}, 50);
    const ChirpSeries is = record(found.radar, {echo, again}, 50);
    for (int rx = 0; rx < 2; ++rx)
        for (std::size_t n = 0; n < 128; ++n)
            CHECK(is.mean_chirp(rx)[n] == Approx(was.mean_chirp(rx)[n]).margin(1.0));
}

TEST_CASE("the start of the decimation filter is found where it shows", "[likeness]") {
    Radar truth = leaky_board();
    truth.chirp.skip_samples = 4;
    truth.chirp.tx_on_s = 1.2e-6;
    truth.receiver.start_up_fraction = 0.12;
    truth.rx[0].start_up_lsb = -300.0;
    truth.rx[1].start_up_lsb = 180.0;
    Radar known = unknowing(truth);
    known.receiver.start_up_fraction = 0.0;
    for (ReceiveChannel& rx : known.rx) rx.start_up_lsb = 0.0;
    const Calibration found = calibrate(record_empty(truth, 50), known, nullptr);
    CHECK(found.radar.receiver.start_up_fraction == Approx(0.12).margin(0.02));
    CHECK(found.radar.rx[0].start_up_lsb == Approx(-300.0).margin(8.0));  // the offset begins there
    CHECK(found.radar.rx[1].start_up_lsb == Approx(180.0).margin(25.0));
}

TEST_CASE("a calibrated board's file reads as what was found", "[likeness]") {
    const Calibration found =
        calibrate(record_empty(leaky_board(), 60), unknowing(leaky_board()), nullptr);
    const MadeUpFolder folder;
    const Radar read =
        read_radar(folder.with("mine.toml", radar_file_text(found.radar, "of a \"test\"")));
    CHECK(read.source == "of a \"test\"");
    CHECK(read.chirp.bin_m() == Approx(found.radar.chirp.bin_m()));
    CHECK(read.chirp.settle_samples() == found.radar.chirp.settle_samples());
    CHECK(read.tx_power_dbm == found.radar.tx_power_dbm);
    CHECK(read.receiver.adc_noise_lsb == Approx(found.radar.receiver.adc_noise_lsb).epsilon(1e-4));
    CHECK(read.limits.chip == found.radar.limits.chip);
    CHECK(gain_towards(read.pattern, {0, 0, -1}) ==
          Approx(gain_towards(found.radar.pattern, {0, 0, -1})));
    REQUIRE(read.rx.size() == found.radar.rx.size());
    CHECK(read.rx[1].inverted);
    CHECK(read.rx[1].dc_offset_lsb == Approx(found.radar.rx[1].dc_offset_lsb).epsilon(1e-4));
    REQUIRE(read.leakage.size() == found.radar.leakage.size());
    CHECK(read.leakage[0].level_dbm == Approx(found.radar.leakage[0].level_dbm).epsilon(1e-4));
}

TEST_CASE("a recording of another radar, or too short a one, is refused", "[likeness]") {
    Radar other = leaky_board();
    other.rx.resize(1);
    other.leakage.clear();
    CHECK(message_of([&] {
              return calibrate(record_empty(leaky_board(), 5), other, nullptr);
          }).find("the recording has 2 RX and 128 samples, radar iwrl6432boost has 1 and 128") ==
          0);
    CHECK(message_of([&] {
              return calibrate(record_empty(leaky_board(), 2), leaky_board(), nullptr);
          }).find("the recording has 2 chirps; record three or more") == 0);
}

TEST_CASE("codes that no scene explains are refused", "[calibration]") {
    const auto refusal = [](const ChirpSeries& series) {
        return message_of([&] { return calibrate(series, leaky_board(), nullptr); });
    };
    const ChirpSeries sound = record_empty(leaky_board(), 5);
    ChirpSeries wide = sound, saturated = sound, dead = sound;
    wide.codes[100] = 2048;
    CHECK(refusal(wide).find("code 2048: is beyond the 12 bits") == 0);
    for (std::size_t i = 0; i < saturated.codes.size(); i += 50) saturated.codes[i] = 2047;
    CHECK(refusal(saturated).find("2.0 % of the codes are at the ends of the ADC") == 0);
    const auto n = static_cast<std::size_t>(dead.n_samples);
    for (std::size_t chirp = 0; chirp < dead.n_chirps(); ++chirp)
        std::fill_n(dead.codes.begin() + static_cast<std::ptrdiff_t>((2 * chirp + 1) * n), n, 3);
    CHECK(refusal(dead) == "RX 1: every code is 3; is the receiver on?");
}

TEST_CASE("a board is like its own recording, and unlike one of another", "[likeness]") {
    const Radar radar = leaky_board();
    const ChirpSeries series = record_empty(radar, 600);  // noise to 3 %
    int unlike = 0;
    for (const LikenessRow& row : compare_with_recording(series, radar, 4).rows) {
        INFO(row.quantity << " " << row.recorded << " " << row.simulated);
        CHECK(row.is_alike());
    }
    Radar other = radar;
    other.receiver.adc_noise_lsb = 2.0;
    other.leakage[0].level_dbm += 3.0;
    other.rx[1].dc_offset_lsb = 0.0;
    for (const LikenessRow& row : compare_with_recording(series, other, 4).rows)
        unlike += row.is_alike() ? 0 : 1;
    CHECK(unlike >= 6);
}

}  // namespace
}  // namespace specula
