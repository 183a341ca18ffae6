#include "sim/adc/receiver_chain.hpp"
#include "sim/channel/path.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/adc/quiet_radar.hpp"

// What boards and frames add: feeds, several TX, motion, I and Q, start-up, drift.

namespace specula {
namespace {

Radar quiet_16_bit_radar() {
    Radar radar = quiet_radar();
    radar.receiver.adc_bits = 16;
    return radar;
}

/// One path per link (rx of the first TX, then of the second), at full scale of a tenth.
BeatSignal tones(const Radar& radar, const std::vector<double>& ranges_m) {
    const FrequencyComb comb = comb_of(radar.chirp);
    Channel channel = silent_channel(static_cast<int>(ranges_m.size()), comb);
    const double transfer =
        0.1 * radar.adc_full_scale_lsb() / radar.amplitude_lsb(radar.tx_power_dbm);
    for (std::size_t link = 0; link < ranges_m.size(); ++link)
        if (ranges_m[link] > 0.0)
            add_path(channel, comb,
                     {.rx = static_cast<int>(link),
                      .length_m = 2.0 * ranges_m[link],
                      .transfer = transfer});
    return dechirp(channel, radar.chirp);
}

TEST_CASE("a feed's gain and phase scale and turn the beat", "[adc]") {
    Radar radar = quiet_16_bit_radar();
    const ReceiverInput input{tones(radar, {0.45}), tones(radar, {0.0})};
    const AdcFrame upright = receive(radar, input);
    radar.rx[0].phase_rad = pi;
    radar.rx[0].gain_db = 20.0 * std::log10(0.5);
    const AdcFrame turned = receive(radar, input);
    for (std::size_t i = 0; i < upright.codes.size(); ++i)
        REQUIRE(std::abs(turned.codes[i] + 0.5 * upright.codes[i]) <= 1.0);  // two roundings
    // A quarter turn of the wave is a quarter turn back of the beat, which is the wave's conjugate.
    radar.rx[0] = {.phase_rad = 0.5 * pi};
    radar.receiver.complex_samples = true;
    const AdcFrame quarter = receive(radar, input);
    for (std::size_t i = 0; i < upright.codes.size(); ++i)
        REQUIRE(std::abs(quarter.quadrature[i] + upright.codes[i]) <= 1.0);
}

TEST_CASE("I and Q are the two parts of the analytic beat", "[adc]") {
    Radar radar = quiet_16_bit_radar();
    radar.receiver.complex_samples = true;
    const AdcFrame frame = receive(radar, {tones(radar, {0.45}), tones(radar, {0.0})});
    REQUIRE(frame.quadrature.size() == frame.codes.size());
    const double amplitude = 0.1 * radar.adc_full_scale_lsb();
    for (std::size_t i = 0; i < frame.codes.size(); ++i)
        CHECK(std::hypot(frame.codes[i], frame.quadrature[i]) == Approx(amplitude).margin(1.0));
    CHECK(receive(quiet_16_bit_radar(), {tones(radar, {0.45}), tones(radar, {0.0})})
              .quadrature.empty());
}

TEST_CASE("each rail of a complex receiver hears the noise of half the band", "[adc]") {
    Radar radar;
    const double real_lsb = ReceiverChain(radar).noise_lsb();
    radar.receiver.complex_samples = true;
    // A tone's power is A^2 over both rails, A^2/2 in one: the same signal over noise in a bin
    // then asks for sqrt(2) of the real receiver's noise in each.
    CHECK(ReceiverChain(radar).noise_lsb() == Approx(std::sqrt(2.0) * real_lsb));
}

TEST_CASE("BPM decoded is TDM, but for rounding", "[adc][mimo]") {
    Radar radar = quiet_16_bit_radar();
    radar.further_tx = {{.position_m = {0.01, 0.0, 0.0}, .inverted = true}};
    radar.chirps_per_frame = 2;
    const ReceiverInput input{tones(radar, {0.40, 0.60}), tones(radar, {0.05, 0.07})};
    const AdcFrame tdm = receive(radar, input);
    radar.multiplexing = Multiplexing::bpm;
    const AdcFrame bpm = receive(radar, input);
    const std::size_t n = 128;
    for (std::size_t i = 0; i < n; ++i) {
        const int sum = bpm.codes[i] + bpm.codes[n + i],
                  difference = bpm.codes[i] - bpm.codes[n + i];
        REQUIRE(std::abs(0.5 * sum - tdm.codes[i]) <= 1.0);
        REQUIRE(std::abs(0.5 * difference - tdm.codes[n + i]) <= 1.0);
    }
    CHECK(std::vector(tdm.codes.begin(), tdm.codes.begin() + 128) !=
          std::vector(tdm.codes.begin() + 128, tdm.codes.end()));
}

TEST_CASE("a moving sample's phase grows from chirp to chirp as Doppler says",
          "[adc][motion][reference]") {
    const auto reference = reference_case("F05_doppler");
    for (const auto& point : reference["points"]) {
        Radar radar = quiet_16_bit_radar();
        radar.receiver.complex_samples = true;
        radar.chirps_per_frame = 2;
        const double period_s = point["inp"]["Tc_s"];
        radar.chirp.idle_s = period_s - radar.chirp.ramp_end_s;
        // Sample 64 is sent at the case's frequency.
        radar.chirp.start_hz += point["inp"]["f_hz"].get<double>() - radar.chirp.frequency_hz(64);
        const double velocity = point["inp"]["v_m_s"];
        const AdcFrame frame = receive(radar, {tones(radar, {0.45}), tones(radar, {0.0})},
                                       {.motion = {.velocity_m_s = velocity}});
        const auto sample = [&](std::size_t i) {
            return Complex(frame.codes[i], frame.quadrature[i]);
        };
        const double grown = std::arg(sample(128 + 64) * std::conj(sample(64)));
        INFO(velocity << " m/s");
        // Rounding to codes of 3277: 0.5 / 3277, twice.
        CHECK(std::remainder(grown - point["expect"]["phase_wrapped_rad"].get<double>(), two_pi) ==
              Approx(0.0).margin(4e-4));
    }
}

TEST_CASE("a vibration far below the wavelength modulates the phase by 2 k d", "[adc][motion]") {
    Radar radar = quiet_16_bit_radar();
    radar.receiver.complex_samples = true;
    radar.chirps_per_frame = 4;
    radar.chirp.idle_s = 1e-3 - radar.chirp.ramp_end_s;
    const double peak_m = 50e-6;
    const ReceiverInput input{tones(radar, {0.45}), tones(radar, {0.0})};
    const AdcFrame still = receive(radar, input);
    const AdcFrame moved =
        receive(radar, input,
                {.motion = {.vibration_m = peak_m, .vibration_hz = 250.0, .vibration_rad = 0.0}});
    const double k = two_pi * radar.chirp.frequency_hz(0) / speed_of_light_m_s;
    for (std::size_t chirp = 0; chirp < 4; ++chirp) {
        const std::size_t i = chirp * 128;
        const Complex turned = Complex(moved.codes[i], moved.quadrature[i]) *
                               std::conj(Complex(still.codes[i], still.quadrature[i]));
        const double time_s = static_cast<double>(chirp) * 1e-3 + 17 / 5e6;
        CHECK(std::arg(turned) ==
              Approx(2.0 * k * peak_m * std::sin(two_pi * 250.0 * time_s)).margin(4e-4));
    }
}

TEST_CASE("before the filter has input its samples hold the start-up's ringing alone", "[adc]") {
    Radar radar;  // with noise
    radar.chirp.skip_samples = 4;
    radar.chirp.tx_on_s = 1e-6;  // 5 samples
    radar.rx[0].dc_offset_lsb = 30.0;
    radar.receiver.high_pass_hz = 0.0;
    REQUIRE(radar.chirp.settle_samples() == -7);
    const ReceiverInput input{tones(radar, {0.45}), tones(radar, {0.0})};
    const AdcFrame quiet = receive(radar, input);
    REQUIRE(quiet.codes.size() == 128);
    for (std::size_t n = 0; n < 7; ++n) CHECK(quiet.codes[n] == 0);
    // Then offset and noise, and only when the TX is on the beat.
    for (std::size_t n = 7; n < 12; ++n) CHECK(std::abs(quiet.codes[n] - 30) < 5);
    CHECK(std::abs(quiet.codes[12] - 30) > 20);

    radar.rx[0].start_up_lsb = -300.0;
    radar.receiver.start_up_fraction = 0.1;
    const AdcFrame ringing = receive(radar, input);
    CHECK(ringing.codes[7] - quiet.codes[7] == -300);
    CHECK(ringing.codes[6] < -20);
    CHECK(ringing.codes[5] > 5);
    CHECK(ringing.codes[40] == quiet.codes[40]);
}

TEST_CASE("leakage that drifts leaves room and sample alone", "[adc]") {
    const Radar radar = quiet_16_bit_radar();
    const auto echo = tones(radar, {0.45}), leak = tones(radar, {0.05}), none = tones(radar, {0.0});
    const AdcFrame together = receive(radar, {echo, leak});
    CHECK(receive(radar, {echo, none, leak}).codes == together.codes);
    const AdcFrame gone = receive(radar, {echo, none, leak}, {.board_factor = {Complex(0.0)}});
    CHECK(gone.codes == receive(radar, {echo, none}).codes);
}

TEST_CASE("noise behind the high-pass keeps the low bins that noise before it loses", "[adc]") {
    Radar radar;
    radar.receiver.adc_bits = 16;
    radar.receiver.temperature_k = 1e-30;
    radar.receiver.adc_noise_lsb = 20.0;
    radar.receiver.high_pass_hz = 1400e3;
    radar.chirps_per_frame = 100;
    const AdcFrame frame = receive(radar, {tones(radar, {0.0}), tones(radar, {0.0})});
    double sum = 0.0;
    for (const std::int16_t code : frame.codes) sum += static_cast<double>(code) * code;
    const double n = static_cast<double>(frame.codes.size());
    CHECK(sum / n == Approx(400.0 + 1.0 / 12.0).epsilon(5.0 * std::sqrt(2.0 / n)));
}

TEST_CASE("phase noise and interference come from the frame's own streams", "[adc]") {
    Radar radar = quiet_16_bit_radar();
    const ReceiverInput input{tones(radar, {0.45}), tones(radar, {0.0})};
    radar.receiver.phase_noise_dbc_hz = -60.0;
    radar.interferer = Interferer{.level_dbm = -40.0,
                                  .start_hz = radar.chirp.start_hz,
                                  .slope_hz_s = radar.chirp.slope_hz_s,
                                  .ramp_s = 30e-6,
                                  .period_s = 40e-6};
    const FrameState first{.draw = {.seed = 1, .purpose = "frame", .item = 1}};
    const FrameState second{.draw = {.seed = 1, .purpose = "frame", .item = 2}};
    CHECK(receive(radar, input, first).codes == receive(radar, input, first).codes);
    CHECK(receive(radar, input, first).codes != receive(radar, input, second).codes);
}

}  // namespace
}  // namespace specula
