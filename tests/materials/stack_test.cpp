#include "materials/stack.hpp"

#include <cmath>

#include "materials/models/conductive.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

using namespace literals;

double cosine(const nlohmann::json& inp) {
    return std::cos(inp.at("theta_deg").get<double>() * pi / 180.0);
}

Electrics dielectric(Complex permittivity) {
    return {.permittivity = permittivity};
}

Stack slab(Complex permittivity, double thickness_m) {
    return {.layers = {{.medium = dielectric(permittivity), .thickness_m = thickness_m}},
            .frequency_hz = 60.0_GHz};
}

TEST_CASE("slabs reflect as the reference says", "[stack][reference]") {
    const auto reference = reference_case("M03_slab");
    const double tolerance = reference.at("tolerance").at("abs");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        Stack stack = slab(complex_of(inp.at("eps")), inp.at("d_m"));
        stack.frequency_hz = inp.at("f_hz");
        const Reflection r = stack_reflection(stack, cosine(inp));
        INFO(inp.dump());
        CHECK(std::abs(r.te - complex_of(point.at("expect").at("r_TE"))) < tolerance);
        CHECK(std::abs(r.tm - complex_of(point.at("expect").at("r_TM"))) < tolerance);
    }
}

TEST_CASE("stacks on half-spaces and on metal reflect as the reference says",
          "[stack][reference]") {
    const auto reference = reference_case("M04_stack");
    const double tolerance = reference.at("tolerance").at("abs");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        Stack stack{.frequency_hz = inp.at("f_hz")};
        for (std::size_t i = 0; i < inp.at("d_m").size(); ++i)
            stack.layers.push_back({.medium = dielectric(complex_of(inp.at("eps_layers").at(i))),
                                    .thickness_m = inp.at("d_m").at(i)});
        if (inp.at("substrate") == "pec")
            stack.backing = PerfectConductor{};
        else
            stack.backing = HalfSpace{dielectric(complex_of(inp.at("substrate")))};
        const Reflection r = stack_reflection(stack, cosine(inp));
        INFO(inp.dump());
        CHECK(std::abs(r.te - complex_of(point.at("expect").at("r_TE"))) < tolerance);
        CHECK(std::abs(r.tm - complex_of(point.at("expect").at("r_TM"))) < tolerance);
    }
}

TEST_CASE("metals reflect, and films on them, as the reference says", "[stack][reference]") {
    const auto reference = reference_case("M05_metals");
    const double decibels = reference.at("tolerance").at("R_dB");
    const auto level_db = [](Complex r) { return 20.0 * std::log10(std::abs(r)); };
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        const auto& expect = point.at("expect");
        const double f_hz = inp.at("f_hz");
        const bool has_film = inp.contains("film");
        const Conductive metal{.conductivity_s_m = inp.at(has_film ? "metal_sigma" : "sigma"),
                               .permeability = inp.value("mu_r", 1.0)};
        Stack stack{.backing = HalfSpace{metal.at(f_hz)}, .frequency_hz = f_hz};
        const Reflection bare = stack_reflection(stack, cosine(inp));
        INFO(inp.dump());
        if (has_film) {
            stack.layers = {{.medium = dielectric(complex_of(inp.at("eps"))),
                             .thickness_m = inp.at("d_m")}};
            const Complex r = stack_reflection(stack, cosine(inp)).te;
            CHECK(std::abs(r - complex_of(expect.at("r_TE"))) <
                  reference.at("tolerance").at("r_abs").get<double>());
            CHECK(std::abs(level_db(bare.te) - expect.at("R_bare_dB").get<double>()) < decibels);
            continue;
        }
        CHECK(std::abs(level_db(bare.te) - expect.at("R_TE_dB").get<double>()) < decibels);
        CHECK(std::abs(level_db(bare.tm) - expect.at("R_TM_dB").get<double>()) < decibels);
        const double k = two_pi * f_hz / speed_of_light_m_s;
        const double skin_m = -1.0 / (k * longitudinal_wavenumber(metal.at(f_hz), 0.0).imag());
        CHECK(skin_m == Approx(expect.at("skin_depth_m"))
                            .epsilon(reference.at("tolerance").at("skin_depth_rel")));
    }
}

TEST_CASE("a rough face loses coherent field as the reference says", "[stack][reference]") {
    const auto reference = reference_case("M08_roughness");
    const double tolerance = reference.at("tolerance").at("rel");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        Stack stack{.backing = HalfSpace{dielectric({6.3, -0.3})}, .frequency_hz = inp.at("f_hz")};
        const Reflection smooth = stack_reflection(stack, cosine(inp));
        std::get<HalfSpace>(stack.backing).roughness_m = inp.at("rms_m");
        const Reflection rough = stack_reflection(stack, cosine(inp));
        const double factor = point.at("expect").at("field_factor");
        CHECK(std::abs(rough.te / smooth.te) == Approx(factor).epsilon(tolerance));
        CHECK(std::abs(rough.tm / smooth.tm) == Approx(factor).epsilon(tolerance));
    }
}

TEST_CASE("slabs reflect the share of the power that the reference says", "[stack][reference]") {
    const auto reference = reference_case("M09_energy");
    const double tolerance = reference.at("tolerance").at("abs");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        Stack stack = slab(complex_of(inp.at("eps")), inp.at("d_m"));
        stack.frequency_hz = inp.at("f_hz");
        const Reflection r = stack_reflection(stack, cosine(inp));
        CHECK(std::abs(std::norm(r.te) - point.at("expect").at("R_TE").get<double>()) < tolerance);
        CHECK(std::abs(std::norm(r.tm) - point.at("expect").at("R_TM").get<double>()) < tolerance);
    }
}

// Rounding of the phase: 2 k d is of the order 10, and so many ulp are lost.
constexpr double rounding = 1e-14;

TEST_CASE("a half-wave lossless slab is invisible, at any angle", "[stack]") {
    for (const double theta_rad : {0.0, 0.5, 1.2}) {
        const double q = std::sqrt(4.0 - std::pow(std::sin(theta_rad), 2));
        const double half_wave_m = speed_of_light_m_s / 60.0_GHz / (2.0 * q);
        const Reflection r = stack_reflection(slab(4.0, half_wave_m), std::cos(theta_rad));
        CHECK(std::abs(r.te) < rounding);
        CHECK(std::abs(r.tm) < rounding);
    }
}

TEST_CASE("a quarter wave of the mean index hides a half-space", "[stack]") {
    const double wavelength_m = speed_of_light_m_s / 60.0_GHz;
    Stack coated = slab(2.0, wavelength_m / (4.0 * std::sqrt(2.0)));
    coated.backing = HalfSpace{dielectric(4.0)};
    CHECK(std::abs(stack_reflection(coated, 1.0).te) < rounding);
    CHECK(std::abs(stack_reflection({.backing = coated.backing, .frequency_hz = 60.0_GHz}, 1.0).te) ==
          Approx(1.0 / 3.0));
}

TEST_CASE("on a perfect conductor a lossless slab reflects all, a lossy one less", "[stack]") {
    for (const double d_m : {0.3_mm, 2.0_mm, 17.0_mm})
        for (const double cos_incidence : {1.0, 0.7, 0.1}) {
            Stack stack = slab(2.6, d_m);
            stack.backing = PerfectConductor{};
            const Reflection all = stack_reflection(stack, cos_incidence);
            CHECK(std::abs(all.te) == Approx(1.0).epsilon(rounding));
            CHECK(std::abs(all.tm) == Approx(1.0).epsilon(rounding));
            stack.layers[0].medium = dielectric({2.6, -0.026});
            const Reflection less = stack_reflection(stack, cos_incidence);
            CHECK(std::abs(less.te) < 1.0);
            CHECK(std::abs(less.tm) < 1.0);
        }
}

TEST_CASE("nothing reflects nothing, and a bare conductor reflects all", "[stack]") {
    const Reflection none = stack_reflection({.frequency_hz = 60.0_GHz}, 0.3);
    CHECK(none.te == Complex(0.0));
    CHECK(none.tm == Complex(0.0));
    const Reflection all =
        stack_reflection({.backing = PerfectConductor{}, .frequency_hz = 60.0_GHz}, 0.3);
    CHECK(all.te == Complex(-1.0));
    CHECK(all.tm == Complex(1.0));
}

TEST_CASE("air on a conductor only delays its reflection", "[stack]") {
    const double d_m = 3.0_mm, cos_incidence = 0.8;
    Stack stack = slab(1.0, d_m);
    stack.backing = PerfectConductor{};
    const double k = two_pi * 60.0_GHz / speed_of_light_m_s;
    const Complex delay = std::polar(1.0, -2.0 * k * d_m * cos_incidence);
    const Reflection r = stack_reflection(stack, cos_incidence);
    CHECK(std::abs(r.te + delay) < rounding);
    CHECK(std::abs(r.tm - delay) < rounding);
    // So close to grazing that 1 - sin^2 rounds to zero, it is still a number.
    CHECK(std::isfinite(stack_reflection(stack, 1e-12).te.real()));
    CHECK(std::isfinite(stack_reflection({.frequency_hz = 60.0_GHz}, 1e-12).tm.real()));
}

TEST_CASE("a slab cut in two parts reflects as the whole", "[stack]") {
    const Complex eps(2.6, -0.1);
    const Stack whole = slab(eps, 5.0_mm);
    Stack parts = slab(eps, 2.0_mm);
    parts.layers.push_back({.medium = dielectric(eps), .thickness_m = 3.0_mm});
    for (const double cos_incidence : {1.0, 0.6}) {
        const Reflection a = stack_reflection(whole, cos_incidence);
        const Reflection b = stack_reflection(parts, cos_incidence);
        CHECK(std::abs(a.te - b.te) < rounding);
        CHECK(std::abs(a.tm - b.tm) < rounding);
    }
}

TEST_CASE("a slab so lossy that nothing returns is a half-space", "[stack]") {
    const Complex eps(5.0, -2.0);  // 1 dB per 0.2 mm: 400 dB there and back through 4 cm
    const Reflection thick = stack_reflection(slab(eps, 4.0_cm), 0.8);
    const Reflection half =
        stack_reflection({.backing = HalfSpace{dielectric(eps)}, .frequency_hz = 60.0_GHz}, 0.8);
    CHECK(std::abs(thick.te - half.te) < rounding);
    CHECK(std::abs(thick.tm - half.tm) < rounding);
    const Electrics metal = Conductive{}.at(60.0_GHz);
    const Stack sheet{.layers = {{.medium = metal, .thickness_m = 3.0_mm}}, .frequency_hz = 60.0_GHz};
    CHECK(std::abs(stack_reflection(sheet, 1.0).te) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("roughness takes coherent power and never adds any", "[stack]") {
    double before = 2.0;
    for (const double roughness_m : {0.0, 0.1_mm, 0.3_mm, 0.6_mm}) {
        Stack stack = slab({6.0, -0.5}, 3.0_cm);
        stack.layers[0].roughness_m = roughness_m;
        const double size = std::abs(stack_reflection(stack, 1.0).te);
        CHECK(size < before);
        before = size;
    }
}

TEST_CASE("an incidence that is no cosine is our own mistake", "[stack]") {
    for (const double cos_incidence : {0.0, -0.5, 1.1, std::nan("")})
        CHECK_THROWS_AS(stack_reflection(slab(2.0, 1.0_mm), cos_incidence), BrokenPromise);
}

}  // namespace
}  // namespace specula
