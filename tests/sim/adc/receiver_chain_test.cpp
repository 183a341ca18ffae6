#include "sim/adc/receiver_chain.hpp"

#include "sim/channel/path.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/adc/quiet_radar.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/spectrum.hpp"

namespace specula {
namespace {

BeatSignal silence(const Radar& radar) {
    return dechirp(silent_channel(static_cast<int>(radar.rx.size()), comb_of(radar.chirp)),
                   radar.chirp);
}

/// One path into rx 0.
BeatSignal tone(const Radar& radar, double range_m, Complex transfer) {
    const FrequencyComb comb = comb_of(radar.chirp);
    Channel channel = silent_channel(static_cast<int>(radar.rx.size()), comb);
    add_path(channel, comb, {.length_m = 2.0 * range_m, .transfer = transfer});
    return dechirp(channel, radar.chirp);
}

/// Transfer of a tone of so many codes' amplitude.
double transfer_for(const Radar& radar, double amplitude_lsb) {
    return amplitude_lsb / radar.amplitude_lsb(radar.tx_power_dbm);
}

/// Mean square of `n_frames` frames of nothing but noise.
struct NoiseSample {
    double mean_square = 0.0;
    double n = 0.0;
};
NoiseSample noise_of(const Radar& radar, int n_frames, const FrameState& state = {}) {
    const ReceiverInput nothing{silence(radar), silence(radar)};
    const ReceiverChain chain(radar);
    Stream noise({.seed = 2, .purpose = "thermal noise"});
    NoiseSample sample;
    for (int i = 0; i < n_frames; ++i)
        for (const std::int16_t code : chain.receive(nothing, state, noise).codes) {
            sample.mean_square += static_cast<double>(code) * code;
            sample.n += 1.0;
        }
    sample.mean_square /= sample.n;
    return sample;
}

TEST_CASE("thermal noise has the power kTF over half the sample rate", "[adc][reference]") {
    const auto point = reference_case("F06_noise_budget")["points"][0];
    Radar radar;
    radar.receiver.temperature_k = point["inp"]["T"];
    radar.receiver.noise_figure_db = point["inp"]["NF"];
    radar.receiver.high_pass_hz = 0.0;
    radar.receiver.gain_db = 80.0;  // some 100 codes rms, so that rounding to codes is no matter
    radar.chirp.sample_rate_hz = point["inp"]["fs"];
    const double expected_dbm = point["expect"]["noise_nyquist_band_dbm"];

    // A tone of that power would have amplitude sqrt(2) times the noise's rms.
    const double rms_lsb = radar.amplitude_lsb(expected_dbm) / std::sqrt(2.0);
    CHECK(ReceiverChain(radar).noise_lsb() == Approx(rms_lsb).epsilon(1e-9));
    const NoiseSample sample = noise_of(radar, 200);
    // The mean square of n normal numbers spreads by sqrt(2 / n) of itself: 0.9 %; five times that
    // is passed by chance once in a million seeds.
    CHECK(sample.mean_square == Approx(rms_lsb * rms_lsb).epsilon(5.0 * std::sqrt(2.0 / sample.n)));
}

TEST_CASE("a board at its own gain hears its noise and the rounding to codes", "[adc]") {
    Radar radar;
    radar.receiver.high_pass_hz = 0.0;
    const double thermal = ReceiverChain(radar).noise_lsb();
    CHECK(thermal > 0.3);  // a fraction of a code: enough to spread the rounding error evenly
    CHECK(thermal < 2.0);
    const NoiseSample sample = noise_of(radar, 400);
    CHECK(sample.mean_square ==
          Approx(thermal * thermal + 1.0 / 12.0).epsilon(5.0 * std::sqrt(2.0 / sample.n)));
}

TEST_CASE("samples of noise know nothing of each other, nor do chirps", "[adc]") {
    Radar radar;
    radar.receiver.high_pass_hz = 0.0;
    radar.receiver.gain_db = 80.0;
    radar.chirps_per_frame = 64;
    radar.rx.resize(2);
    const AdcFrame frame = receive(radar, {silence(radar), silence(radar)});
    REQUIRE(frame.codes.size() == 64u * 2u * 128u);
    const auto correlation = [&](std::size_t apart) {
        double product = 0.0, square = 0.0;
        for (std::size_t i = 0; i + apart < frame.codes.size(); ++i) {
            product += static_cast<double>(frame.codes[i]) * frame.codes[i + apart];
            square += static_cast<double>(frame.codes[i]) * frame.codes[i];
        }
        return product / square;
    };
    // Of n independent pairs a correlation spreads by 1 / sqrt(n) = 0.008.
    CHECK(std::abs(correlation(1)) < 0.04);    // neighbours
    CHECK(std::abs(correlation(128)) < 0.04);  // the other receiver
    CHECK(std::abs(correlation(256)) < 0.04);  // the next chirp
}

TEST_CASE("a receiver's gain raises its echo and its noise alike", "[adc]") {
    Radar radar = quiet_radar();
    const ReceiverInput input{tone(radar, 0.45, transfer_for(radar, 500.0)), silence(radar)};
    const AdcFrame nominal = receive(radar, input);
    const AdcFrame doubled = receive(radar, input, {.gain_db = decibel(2.0)});
    for (std::size_t i = 0; i < nominal.codes.size(); ++i)
        REQUIRE(std::abs(doubled.codes[i] - 2 * nominal.codes[i]) <= 1);  // rounding, twice 1/2

    Radar noisy;
    noisy.receiver.gain_db = 80.0;
    const NoiseSample low = noise_of(noisy, 20), high = noise_of(noisy, 20, {.gain_db = 6.0});
    CHECK(10.0 * std::log10(high.mean_square / low.mean_square) ==
          Approx(6.0).margin(0.01));  // the same noise, rounded to codes of a hundredth
}

TEST_CASE("a mirror's tone fills as many codes as the radar equation says", "[adc][reference]") {
    const auto reference = reference_case("F10_absolute_power");
    const auto& point = reference["points"][2];
    REQUIRE(point["inp"]["target"] == "infinite mirror");
    const double height_m = point["inp"]["R_m"], frequency_hz = point["inp"]["f_hz"];
    const double gain = std::pow(10.0, point["inp"]["Gt_dbi"].get<double>() / 10.0);

    Radar radar = quiet_radar();
    radar.tx_power_dbm = point["inp"]["Pt_dbm"];
    // Image source: the wave of an antenna 2H away, reflected upside down.
    const double transfer =
        -speed_of_light_m_s / frequency_hz / (4.0 * pi) * gain / (2.0 * height_m);
    const AdcFrame frame = receive(radar, {tone(radar, height_m, transfer), silence(radar)});

    const std::vector<double> codes(frame.codes.begin(), frame.codes.end());
    const double bin = radar.chirp.bin_of(height_m);
    const double found_lsb = amplitude_at(codes, "blackman", bin);
    // Full scale at the ADC is 10 dBm, behind 40 dB of gain: 2048 codes.
    const double expected_lsb =
        2048.0 * std::pow(10.0, (point["expect"]["Pr_dbm"].get<double>() + 40.0 - 10.0) / 20.0);
    CHECK(std::abs(decibel(found_lsb / expected_lsb)) < reference["tolerance"]["db"].get<double>());
    CHECK(std::abs(decibel(found_lsb / expected_lsb)) < 0.005);  // rounding of 320 codes
}

TEST_CASE("codes are rounded to the nearest and end at both rails", "[adc]") {
    Radar radar = quiet_radar();
    radar.rx = {ReceiveChannel{.dc_offset_lsb = 10.4},  ReceiveChannel{.dc_offset_lsb = 10.6},
                ReceiveChannel{.dc_offset_lsb = -10.6}, ReceiveChannel{.dc_offset_lsb = 2046.9},
                ReceiveChannel{.dc_offset_lsb = 1e6},   ReceiveChannel{.dc_offset_lsb = -2048.4},
                ReceiveChannel{.dc_offset_lsb = -1e6}};
    const std::vector<int> expected{10, 11, -11, 2047, 2047, -2048, -2048};
    const AdcFrame frame = receive(radar, {silence(radar), silence(radar)});
    for (std::size_t rx = 0; rx < expected.size(); ++rx)
        for (std::size_t i = 0; i < 128; ++i) REQUIRE(frame.codes[rx * 128 + i] == expected[rx]);

    radar.receiver.adc_bits = 8;
    const AdcFrame coarse = receive(radar, {silence(radar), silence(radar)});
    CHECK(coarse.codes[4 * 128] == 127);
    CHECK(coarse.codes[6 * 128] == -128);
    radar.receiver.adc_bits = 16;
    const AdcFrame fine = receive(radar, {silence(radar), silence(radar)});
    CHECK(fine.codes[4 * 128] == 32767);
    CHECK(fine.codes[6 * 128] == -32768);
}

TEST_CASE("a tone of full scale just touches the rails", "[adc]") {
    Radar radar = quiet_radar();
    const auto largest = [&](double amplitude_lsb) {
        const AdcFrame frame =
            receive(radar, {tone(radar, 0.45, transfer_for(radar, amplitude_lsb)), silence(radar)});
        return *std::max_element(frame.codes.begin(), frame.codes.end());
    };
    CHECK(radar.amplitude_lsb(radar.receiver.full_scale_dbm - radar.receiver.gain_db) ==
          Approx(2048.0));
    CHECK(largest(1000.0) <= 1000);
    CHECK(largest(1000.0) > 950);  // 11 samples a turn: the crest is met within cos(pi / 11)
    CHECK(largest(4000.0) == 2047);
}

TEST_CASE("an inverted receiver gives the opposite codes, but not the opposite offset", "[adc]") {
    Radar radar = quiet_radar();
    const ReceiverInput input{tone(radar, 0.45, transfer_for(radar, 500.0)),
                              tone(radar, 0.05, transfer_for(radar, 300.0))};
    const AdcFrame upright = receive(radar, input);
    radar.rx[0].inverted = true;
    const AdcFrame inverted = receive(radar, input);
    for (std::size_t i = 0; i < upright.codes.size(); ++i)
        REQUIRE(inverted.codes[i] == -upright.codes[i]);
    radar.rx[0].dc_offset_lsb = 100.0;
    const AdcFrame offset = receive(radar, input);
    for (std::size_t i = 0; i < upright.codes.size(); ++i)
        REQUIRE(offset.codes[i] == 100 - upright.codes[i]);
}

TEST_CASE("a sample that moves turns its echo at each sample's own frequency, leakage stays",
          "[adc]") {
    Radar radar = quiet_radar();
    const double moved_m = 1.25e-3;  // about a quarter of a wavelength: half a turn
    const Complex transfer = transfer_for(radar, 800.0);
    const BeatSignal leakage = tone(radar, 0.05, transfer_for(radar, 300.0));
    const AdcFrame moved =
        receive(radar, {tone(radar, 0.45, transfer), leakage}, {.displacement_m = moved_m});
    const AdcFrame farther = receive(radar, {tone(radar, 0.45 + moved_m, transfer), leakage});
    CHECK(moved.codes == farther.codes);
    CHECK(moved.codes != receive(radar, {tone(radar, 0.45, transfer), leakage}).codes);
}

TEST_CASE("the filter settles before the first sample kept", "[adc]") {
    // With the pole at 175 kHz, 17 settling samples at 5 MHz leave exp(-17 * 0.22) = 2.4 % of a
    // step; without settling the first sample would show all of it.
    Radar radar = quiet_radar();
    radar.receiver.high_pass_hz = 175e3;
    REQUIRE(radar.chirp.settle_samples() == 17);
    const AdcFrame frame =
        receive(radar, {silence(radar), tone(radar, 0.0, transfer_for(radar, 1000.0))});
    CHECK(std::abs(frame.codes[0]) < 100);  // two poles: (1 - x) exp(-x), 6.6 % of 1000
    CHECK(std::abs(frame.codes[0]) > 10);
    CHECK(frame.codes[127] == 0);
}

TEST_CASE("every frame draws as much noise as any other", "[adc]") {
    const Radar radar;
    const ReceiverChain chain(radar);
    const ReceiverInput loud{tone(radar, 0.45, transfer_for(radar, 5000.0)), silence(radar)};
    const ReceiverInput nothing{silence(radar), silence(radar)};
    Stream first({.seed = 3, .purpose = "thermal noise"}), second = first;
    chain.receive(loud, {.displacement_m = 1e-4}, first);
    chain.receive(nothing, {}, second);
    CHECK(first.bits() == second.bits());
}

}  // namespace
}  // namespace specula
