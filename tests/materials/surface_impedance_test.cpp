#include "materials/surface_impedance.hpp"

#include <cmath>

#include "materials/stack.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

double decibel(Complex r) {
    return 20.0 * std::log10(std::abs(r));
}

Electrics metal_at(double conductivity_s_m, double permeability, double f_hz) {
    return Conductive{conductivity_s_m, permeability}.at(f_hz);
}

TEST_CASE("metals reflect as the reference's, exactly and by their impedance",
          "[surface_impedance][reference]") {
    const auto reference = reference_case("M05_metals");
    const auto& tolerance = reference.at("tolerance");
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        if (!inp.contains("sigma")) continue;
        INFO(inp.dump());
        const double f_hz = inp.at("f_hz");
        const double cosine = std::cos(inp.at("theta_deg").get<double>() * pi / 180.0);
        const Conductive metal{inp.at("sigma"), inp.at("mu_r")};
        const Reflection exact = stack_reflection({{}, HalfSpace{metal.at(f_hz)}, f_hz}, cosine);
        const SurfaceImpedance impedance(metal, f_hz);
        const Reflection leontovich = impedance.reflection(cosine);
        const double db = tolerance.at("R_dB");
        CHECK(std::abs(decibel(exact.te) - expect.at("R_TE_dB").get<double>()) < db);
        CHECK(std::abs(decibel(exact.tm) - expect.at("R_TM_dB").get<double>()) < db);
        CHECK(std::abs(decibel(leontovich.te) - expect.at("R_TE_leontovich_dB").get<double>()) <
              db);
        CHECK(std::abs(decibel(leontovich.tm) - expect.at("R_TM_leontovich_dB").get<double>()) <
              db);
        const double relative = tolerance.at("skin_depth_rel");
        CHECK(impedance.skin_depth_m() ==
              Approx(expect.at("skin_depth_m").get<double>()).epsilon(relative));
        CHECK(impedance.resistance_ohm() ==
              Approx(expect.at("Rs_ohm").get<double>()).epsilon(relative));
    }
}

TEST_CASE("a film of rust or paint turns the phase of its metal as the reference says",
          "[surface_impedance][reference]") {
    const auto reference = reference_case("M05_metals");
    const double tolerance = reference.at("tolerance").at("r_abs");
    int n_films = 0;
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        if (!inp.contains("film")) continue;
        ++n_films;
        INFO(inp.dump());
        const double f_hz = inp.at("f_hz");
        const HalfSpace bare{metal_at(inp.at("metal_sigma"), 1.0, f_hz)};
        const Stack coated{
            {{.medium = {complex_of(inp.at("eps"))}, .thickness_m = inp.at("d_m")}}, bare, f_hz};
        const Complex found = stack_reflection(coated, 1.0).te;
        CHECK(std::abs(found - complex_of(expect.at("r_TE"))) < tolerance);
        CHECK(decibel(found) == Approx(expect.at("R_dB").get<double>()).margin(1e-6));
        CHECK(decibel(stack_reflection({{}, bare, f_hz}, 1.0).te) ==
              Approx(expect.at("R_bare_dB").get<double>()).margin(1e-6));
    }
    CHECK(n_films == 2);
}

TEST_CASE("the impedance and the exact half-space of a metal agree in the complex plane",
          "[surface_impedance]") {
    for (const double conductivity : {1e6, 1e7, 6e7})
        for (const double permeability : {1.0, 2.0, 100.0})
            for (const double cosine : {1.0, 0.5, 0.1}) {
                const Conductive metal{conductivity, permeability};
                const Reflection exact =
                    stack_reflection({{}, HalfSpace{metal.at(60e9)}, 60e9}, cosine);
                const Reflection near = SurfaceImpedance(metal, 60e9).reflection(cosine);
                // Their refraction differs by 1/(eps mu) of an impedance below 0.1 of free space.
                CHECK(std::abs(exact.te - near.te) < 1e-6);
                CHECK(std::abs(exact.tm - near.tm) < 1e-6 / cosine);
            }
}

TEST_CASE("the skin depth is where the exact field has fallen to 1/e", "[surface_impedance]") {
    const Conductive iron{0.8e7, 1.5};
    CHECK(penetration_depth_m(iron.at(60e9), 60e9) ==
          Approx(SurfaceImpedance(iron, 60e9).skin_depth_m()).epsilon(1e-6));  // 1 + 1/(2 |eps|)
}

TEST_CASE("a wave goes on for ever where nothing absorbs it", "[surface_impedance]") {
    CHECK(std::isinf(penetration_depth_m({2.6}, 60e9)));
    CHECK(penetration_depth_m({2.6}, 60e9) > 0.0);
    // Weak losses: lambda n / (pi eps'').
    const double expected = speed_of_light_m_s / 60e9 * std::sqrt(2.6) / (pi * 0.026);
    CHECK(penetration_depth_m({Complex(2.6, -0.026)}, 60e9) == Approx(expected).epsilon(1e-4));
}

}  // namespace
}  // namespace specula
