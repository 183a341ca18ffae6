#include "sim/link_budget.hpp"

#include "sim/clutter.hpp"
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
    CHECK(budget.beat_hz ==
          Approx(radar.chirp.slope_hz_s * 2.0 * height_m / speed_of_light_m_s));
    const double times_corner = budget.beat_hz / radar.receiver.high_pass_hz;
    const double passed = times_corner * times_corner / (1.0 + times_corner * times_corner);
    CHECK(budget.high_pass_db == Approx(decibel(passed)));
    CHECK(budget.amplitude_lsb ==
          Approx(2048.0 * passed *
                 std::pow(10.0, (budget.received_dbm + radar.receiver.gain_db -
                                 radar.receiver.full_scale_dbm) / 20.0)));
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
