#include <Eigen/Dense>
#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/sim/plate_scene.hpp"
#include "tests/tools/validate/made_up_case.hpp"
#include "tools/validate/cases/strip_echo.hpp"

// Strips that no reference file has, against a method of moments of our own (TM: EFIE, pulses and
// point matching).

namespace specula {
namespace {

/// Hankel's function of the second kind and order zero: a line source's field.
Complex line_field(double kr) {
    return {std::cyl_bessel_j(0.0, kr), -std::cyl_neumann(0.0, kr)};
}

/// TM echo of a conducting strip over that of an infinite mirror.
Complex moments_echo(const StripScene& scene) {
    constexpr int per_wavelength = 20;  // 0.02 dB from 40 on these strips
    constexpr double euler_gamma = 1.7810724179901979;
    const double k = two_pi * scene.frequency_hz / speed_of_light_m_s;
    const int n = static_cast<int>(std::ceil(per_wavelength * k * scene.width_m / two_pi));
    const double step_m = scene.width_m / n;
    Eigen::VectorXcd by_distance(n), incident(n);
    by_distance[0] = Complex(1.0, -2.0 / pi * (std::log(0.25 * euler_gamma * k * step_m) - 1.0));
    for (int i = 1; i < n; ++i) by_distance[i] = line_field(k * i * step_m);
    Eigen::MatrixXcd matrix(n, n);
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column)
            matrix(row, column) = by_distance[std::abs(row - column)];
        const double x_m = (row + 0.5) * step_m - 0.5 * scene.width_m;
        incident[row] = line_field(k * std::hypot(x_m * std::cos(scene.tilt_rad),
                                                  scene.height_m + x_m * std::sin(scene.tilt_rad)));
    }
    const Eigen::VectorXcd currents = matrix.partialPivLu().solve(incident);
    return incident.cwiseProduct(currents).sum() / line_field(2.0 * k * scene.height_m);
}

double level_db(Complex h) {
    return 20.0 * std::log10(std::abs(h));
}

TEST_CASE("edge currents bring the TM echo of other strips to the method of moments", "[W01]") {
    constexpr double degree = pi / 180.0;
    for (const StripScene& scene :
         {StripScene{0.06, 0.3, 12.0 * degree, 60e9}, StripScene{0.08, 0.5, -7.0 * degree, 61.5e9},
          StripScene{0.05, 0.25, 20.0 * degree, 57e9}}) {
        const StripEcho strip(scene, {.polarisation = LinePolarisation::tm});
        const double expected = level_db(moments_echo(scene));
        const double optics = level_db(strip.of(perfect_conductor()));
        const double with_edges = level_db(strip.with_edge_currents(perfect_conductor()));
        INFO(expected << " dB, optics " << optics << ", with edges " << with_edges);
        CHECK(expected < -10.0);
        // 0.02 dB of the moments' step and the wave from edge to edge, 1/(k width) of the fringe.
        CHECK(std::abs(with_edges - expected) < 0.2);
        CHECK(std::abs(with_edges - expected) < 0.5 * std::abs(optics - expected));
    }
}

TEST_CASE("how long the traced strip is does not matter", "[W01]") {
    const StripScene scene{0.1, 0.45, 10.0 * pi / 180.0, 60e9};
    for (const auto polarisation : {LinePolarisation::tm, LinePolarisation::te}) {
        const StripEcho strip(scene, {.polarisation = polarisation});
        const StripEcho longer(scene, {.polarisation = polarisation, .reach = 5.0});
        const Reflector mirror = perfect_conductor();
        const auto off = [](Complex a, Complex b) { return std::abs(level_db(a / b)); };
        CHECK(off(strip.of(mirror), longer.of(mirror)) < 0.005);
        CHECK(off(strip.with_edge_currents(mirror), longer.with_edge_currents(mirror)) < 0.005);
    }
}

TEST_CASE("a wide strip below a low source is the infinite mirror", "[W01]") {
    const StripScene scene{0.3, 0.05, 0.0, 60e9};
    const Complex echo =
        StripEcho(scene, {.polarisation = LinePolarisation::te}).of(perfect_conductor());
    // Its rims, 16 cm away against 5 cm and seen at 72 degrees, ripple by 2 %.
    CHECK(std::abs(echo - 1.0) < 0.03);
}

TEST_CASE("a W case is judged by level above and below -10 dB", "[W01]") {
    const nlohmann::json inp{
        {"strip_width_m", 0.1}, {"H_m", 0.45}, {"tilt_deg", 10}, {"f_hz", 60e9}};
    const nlohmann::json tolerance{{"db_if_above_minus10", 1e-9}, {"db_if_below_minus10", 0.01}};
    check_passes(case_of("W01_other", inp, {{"PO_TM_db", -17.0056}}, tolerance));
    CHECK(validated(case_of("W01_other", inp, {{"PO_TM_db", -17.05}}, tolerance)).verdict() ==
          Verdict::fail);
    CHECK(
        validated(case_of("W01_other",
                          {{"strip_width_m", 3.0}, {"H_m", 0.3}, {"tilt_deg", 30}, {"f_hz", 60e9}},
                          {{"PO_TM_db", 0.0}}, tolerance))
            .verdict() == Verdict::not_computable);
}

TEST_CASE("a dielectric strip with the polarisation across it is computed too", "[W02]") {
    const nlohmann::json inp{{"eps", {2.6, -0.026}}, {"d_m", 0.005},  {"width_m", 0.3},
                             {"H_m", 0.45},          {"tilt_deg", 0}, {"f_hz", 60e9},
                             {"pol", "TE_z"}};
    const Stack slab{{{.medium = {{2.6, -0.026}}, .thickness_m = 0.005}}, HalfSpace{}, 60e9};
    const double straight_db = level_db(stack_reflection(slab, 1.0).tm);
    // The strip of 30 cm ripples by 0.4 dB about the infinite slab, as its metal twin does (W01).
    check_passes(case_of("W02_other", inp, {{"PO_slab_db", straight_db}}, {{"db", 0.6}}));
    auto unknown = inp;
    unknown["pol"] = "circular";
    CHECK(validated(case_of("W02_other", unknown, {{"PO_slab_db", straight_db}}, {{"db", 0.6}}))
              .verdict() == Verdict::not_computable);
}

}  // namespace
}  // namespace specula
