#include "sim/simulate.hpp"

#include "sim/link_budget.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/plate_scene.hpp"
#include "tests/sim/spectrum.hpp"

namespace specula {
namespace {

Scene wide_mirror(double height_m) {
    Scene scene;
    scene.sample.material = "aluminium";
    scene.sample.face = {.size_x_m = 0.7, .size_y_m = 0.7};
    scene.pose.height_m = height_m;
    return scene;
}

AdcFrame simulated(const Scene& scene) {
    Stream noise({.seed = 1, .purpose = "thermal noise"});
    return simulate(scene, library(), noise);
}

/// Amplitude and place of the strongest tone of an RX.
struct Peak {
    double amplitude_lsb = 0.0;
    double bin = 0.0;
};
Peak peak_of(const AdcFrame& frame) {
    const std::vector<double> codes(frame.codes.begin(), frame.codes.begin() + frame.n_samples);
    Peak peak;
    for (double bin = 3.0; bin < 40.0; bin += 0.05) {
        const double amplitude_lsb = amplitude_at(codes, "blackman", bin);
        if (amplitude_lsb > peak.amplitude_lsb) peak = {amplitude_lsb, bin};
    }
    return peak;
}

TEST_CASE("a wide metal plate reads in ADC codes what the radar equation says of a mirror",
          "[sim][reference]") {
    const auto reference = reference_case("F10_absolute_power");
    const auto& point = reference["points"][2];
    REQUIRE(point["inp"]["target"] == "infinite mirror");
    Scene scene = wide_mirror(point["inp"]["R_m"]);
    scene.radar.tx_power_dbm = point["inp"]["Pt_dbm"];
    scene.radar.pattern = IsotropicPattern{.gain_dbi = point["inp"]["Gt_dbi"]};
    scene.radar.chirp.start_hz +=
        point["inp"]["f_hz"].get<double>() - scene.radar.chirp.centre_hz();

    const Peak peak = peak_of(simulated(scene));
    const double beat_hz = scene.radar.chirp.beat_hz(scene.pose.height_m);
    const double times_corner = beat_hz / scene.radar.receiver.high_pass_hz;
    const double high_pass_db =
        decibel(times_corner * times_corner / (1.0 + times_corner * times_corner));
    const double expected_db = point["expect"]["Pr_dbm"].get<double>() + high_pass_db +
                               scene.radar.receiver.gain_db - scene.radar.receiver.full_scale_dbm;
    // The case's own 0.3 dB; the plate's far edges ripple by about 0.1 dB over the chirp.
    CHECK(decibel(peak.amplitude_lsb / 2048.0) ==
          Approx(expected_db).margin(reference["tolerance"]["db"].get<double>()));
    CHECK(peak.bin == Approx(scene.radar.chirp.bin_of(scene.pose.height_m)).margin(0.1));
}

TEST_CASE("the link budget foretells what the simulator records", "[sim]") {
    for (const double height_m : {0.3, 0.45, 0.7}) {
        Scene scene = wide_mirror(height_m);
        scene.radar.pattern = PatchPattern{};
        const LinkBudget budget = mirror_budget(scene.radar, height_m);
        INFO("height " << height_m);
        // 0.07 dB of the filter, 0.2 dB of the edges, 0.1 dB of the chirp's band at one frequency.
        CHECK(decibel(peak_of(simulated(scene)).amplitude_lsb / budget.amplitude_lsb) ==
              Approx(0.0).margin(0.4));
    }
}

TEST_CASE("leakage reads its power and stands at its apparent range", "[sim]") {
    Radar radar;
    radar.rx.resize(2);
    radar.leakage = {{.rx = 1, .range_m = 0.3, .level_dbm = -30.0, .phase_rad = 0.4}};
    const FrequencyComb comb = comb_of(radar.chirp);
    const Channel channel = leakage_channel(radar, {.leakage_db = 2.0, .leakage_rad = 0.1});
    for (int i = 0; i < comb.n; ++i) {
        CHECK(channel.of_rx(0)[i] == Complex(0.0));
        CHECK(decibel(std::abs(channel.of_rx(1)[i])) ==
              Approx(-30.0 + 2.0 - radar.tx_power_dbm).epsilon(1e-12));
    }
    const Complex first = channel.of_rx(1)[0];
    const double turns = comb.first_hz * 0.6 / speed_of_light_m_s;
    CHECK(std::abs(std::arg(first / std::polar(1.0, 0.5 - two_pi * turns))) < 1e-9);
}

TEST_CASE("the same noise gives the same frame, other noise another", "[sim]") {
    Scene scene = wide_mirror(0.45);
    scene.sample.face = {.size_x_m = 0.1, .size_y_m = 0.1};
    const AdcFrame first = simulated(scene);
    CHECK(simulated(scene).codes == first.codes);
    Stream other({.seed = 2, .purpose = "thermal noise"});
    CHECK(simulate(scene, library(), other).codes != first.codes);
}

TEST_CASE("a plate of 15 cm tilted by 10 degrees loses its echo, one of 30 cm does not", "[sim]") {
    // physics.md 5.2: -8 dB and +0.4 dB, mean over the band; here the peak of one chirp, so 1.5 dB.
    const auto lost_db = [](double size_m) {
        Scene scene;
        scene.radar.pattern = PatchPattern{};
        scene.sample.material = "aluminium";
        scene.sample.face = {.size_x_m = size_m, .size_y_m = size_m};
        const double straight = peak_of(simulated(scene)).amplitude_lsb;
        scene.pose.sample.about_y_rad = 10.0 * pi / 180.0;
        return decibel(peak_of(simulated(scene)).amplitude_lsb / straight);
    };
    CHECK(lost_db(0.15) == Approx(-8.1).margin(1.5));
    CHECK(lost_db(0.30) == Approx(0.4).margin(1.5));
}

}  // namespace
}  // namespace specula
