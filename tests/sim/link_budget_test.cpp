#include "sim/link_budget.hpp"

#include "sim/clutter.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"
#include "tests/sim/deviation.hpp"

namespace specula {
namespace {

TEST_CASE("the link budget of a mirror is that of the radar equation", "[sim][reference]") {
    const auto reference = reference_case("F10_absolute_power");
    const auto& point = reference["points"][2];
    REQUIRE(point["inp"]["target"] == "infinite mirror");
    Radar radar;
    radar.tx_power_dbm = point["inp"]["Pt_dbm"];
    radar.pattern = IsotropicPattern{.gain_dbi = point["inp"]["Gt_dbi"]};
    radar.chirp.start_hz += point["inp"]["f_hz"].get<double>() - radar.chirp.centre_hz();
    const double height_m = point["inp"]["R_m"];

    const LinkBudget budget = mirror_budget(radar, height_m);
    CHECK(budget.received_dbm == Approx(point["expect"]["Pr_dbm"].get<double>()).margin(1e-9));
    CHECK(budget.beat_hz == Approx(radar.chirp.slope_hz_s * 2.0 * height_m / speed_of_light_m_s));
    const double times_corner = budget.beat_hz / radar.receiver.high_pass_hz;
    const double passed = times_corner * times_corner / (1.0 + times_corner * times_corner);
    CHECK(budget.high_pass_db == Approx(decibel(passed)));
    CHECK(budget.amplitude_lsb ==
          Approx(2048.0 * passed *
                 std::pow(10.0, (budget.received_dbm + radar.receiver.gain_db -
                                 radar.receiver.full_scale_dbm) /
                                    20.0)));
}

TEST_CASE("every stage differs from the one before by what stands between", "[sim]") {
    Radar radar;
    radar.pattern = PatchPattern{};
    const auto stages = budget_stages(radar, 0.45);
    REQUIRE(stages.size() == 7);
    const LinkBudget mirror = mirror_budget(radar, 0.45);
    CHECK(stages[1].echo_dbm - stages[0].echo_dbm == Approx(5.5));
    CHECK(stages[2].echo_dbm == Approx(mirror.received_dbm));
    // -174 dBm/Hz over 2.5 MHz.
    CHECK(*stages[2].noise_dbm == Approx(-173.975 + decibel(std::sqrt(2.5e6))).margin(1e-3));
    CHECK(*stages[3].noise_dbm - *stages[2].noise_dbm == Approx(12.0));
    CHECK(*stages[4].noise_dbm - *stages[3].noise_dbm == Approx(40.0));
    CHECK(stages[4].echo_dbm - stages[3].echo_dbm == Approx(40.0));
    CHECK(stages[5].echo_dbm - stages[4].echo_dbm == Approx(mirror.high_pass_db));
    // With x = f / fc, the integral of 1 - (x^2 / (1 + x^2))^2 over all x is 3 pi / 4, of which
    // nearly 2 / x lies beyond x.
    const double end = 2.5e6 / 175e3;
    CHECK(*stages[5].noise_dbm - *stages[4].noise_dbm ==
          Approx(10.0 * std::log10(1.0 - (0.75 * pi - 2.0 / end) / end)).margin(0.01));
    CHECK(power_of_lsb_dbm(radar, radar.amplitude_lsb(-33.0)) ==
          Approx(-33.0 + radar.receiver.gain_db));
}

TEST_CASE("without a high-pass nothing is lost in it", "[sim]") {
    Radar radar;
    radar.receiver.high_pass_hz = 0.0;
    CHECK(mirror_budget(radar, 0.45).high_pass_db == 0.0);
    CHECK(std::isfinite(mirror_budget(radar, 0.45).amplitude_lsb));
}

TEST_CASE("a mirror twice as far away returns a quarter of the power", "[sim]") {
    const Radar radar;
    CHECK(decibel(mirror_transfer(radar, 0.9) / mirror_transfer(radar, 0.45)) ==
          Approx(decibel(0.5)));
}

}  // namespace
}  // namespace specula
