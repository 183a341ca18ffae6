#include "materials/transmission.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

double cosine_of(const nlohmann::json& inp) {
    return std::cos(inp.at("theta_deg").get<double>() * pi / 180.0);
}

Stack slab_of(const nlohmann::json& inp) {
    return {{{.medium = {complex_of(inp.at("eps"))}, .thickness_m = inp.at("d_m")}},
            HalfSpace{},
            inp.at("f_hz")};
}

TEST_CASE("a slab reflects and lets through what the reference's does",
          "[transmission][reference]") {
    const auto reference = reference_case("M03_slab");
    const double tolerance = reference.at("tolerance").at("abs");
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        INFO(inp.dump());
        const Transmission t = stack_transmission(slab_of(inp), cosine_of(inp));
        CHECK(std::abs(t.te - complex_of(expect.at("t_TE"))) < tolerance);
        CHECK(std::abs(t.tm - complex_of(expect.at("t_TM"))) < tolerance);
        const Reflection r = stack_reflection(slab_of(inp), cosine_of(inp));
        CHECK(std::abs(r.te - complex_of(expect.at("r_TE"))) < tolerance);
        CHECK(std::abs(r.tm - complex_of(expect.at("r_TM"))) < tolerance);
    }
}

TEST_CASE("the power of a slab goes where the reference's does", "[transmission][reference]") {
    const auto reference = reference_case("M09_energy");
    const double tolerance = reference.at("tolerance").at("abs");
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        INFO(inp.dump());
        const StackPower power = stack_power(slab_of(inp), cosine_of(inp));
        for (const auto& [suffix, shares] : {std::pair("_TE", power.te), {"_TM", power.tm}}) {
            const auto value = [&, name = std::string(suffix)](const std::string& what) {
                return expect.at(what + name).get<double>();
            };
            CHECK(std::abs(shares.reflected - value("R")) < tolerance);
            CHECK(std::abs(shares.transmitted - value("T")) < tolerance);
            CHECK(std::abs(shares.absorbed - value("A")) < tolerance);
        }
    }
}

/// Characteristic matrices, an independent way to the same numbers.
struct Matrix {
    Complex a = 1.0, b = 0.0, c = 0.0, d = 1.0;

    Matrix operator*(const Matrix& m) const {
        return {a * m.a + b * m.c, a * m.b + b * m.d, c * m.a + d * m.c, c * m.b + d * m.d};
    }
};

Complex matrix_transmission(const Stack& stack, double cosine, bool te) {
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    const double sin_squared = 1.0 - cosine * cosine;
    const auto admittance = [&](const Electrics& medium) {
        const Complex q = longitudinal_wavenumber(medium, sin_squared);
        return te ? q / medium.permeability : medium.permittivity / q;  // tangential H over E
    };
    Matrix product;
    for (const Layer& layer : stack.layers) {
        const Complex y = admittance(layer.medium);
        const Complex phase =
            k * layer.thickness_m * longitudinal_wavenumber(layer.medium, sin_squared);
        const Complex j(0.0, 1.0);
        product = product * Matrix{std::cos(phase), j * std::sin(phase) / y,
                                   j * y * std::sin(phase), std::cos(phase)};
    }
    const Electrics& last = std::get<HalfSpace>(stack.backing).medium;
    const Complex in = te ? cosine : 1.0 / cosine, out = admittance(last);
    const Complex tangential =
        2.0 * in / (in * product.a + in * out * product.b + product.c + out * product.d);
    if (te) return tangential;
    // From tangential E to all of E: over the cosine, q/n, of the ray in either medium.
    const Complex n = std::sqrt(last.permittivity * last.permeability);
    return tangential * cosine * n / longitudinal_wavenumber(last, sin_squared);
}

TEST_CASE("recursion and characteristic matrix agree on what gets through", "[transmission]") {
    const std::vector<Stack> stacks{
        {{{{Complex(2.73, -0.12)}, 0.0125}, {{1.0}, 0.05}, {{Complex(2.73, -0.12)}, 0.0125}},
         HalfSpace{},
         60e9},
        {{{{Complex(2.0, -0.113)}, 0.018}}, HalfSpace{{Complex(5.24, -0.34)}}, 61e9},
        {{{{Complex(3.0, -0.3), 1.4}, 0.002}, {{Complex(9.0, -0.1), 2.0}, 0.001}},
         HalfSpace{{Complex(4.0, -1.0), 1.2}},
         58e9},
        {{}, HalfSpace{{Complex(7.5, -0.15)}}, 60e9}};
    for (const Stack& stack : stacks)
        for (const double cosine : {1.0, 0.8, 0.5, 0.1}) {
            const Transmission t = stack_transmission(stack, cosine);
            CHECK(std::abs(t.te - matrix_transmission(stack, cosine, true)) < 1e-12);
            CHECK(std::abs(t.tm - matrix_transmission(stack, cosine, false)) < 1e-12);
        }
}

TEST_CASE("both polarisations are one at normal incidence", "[transmission]") {
    const Stack stack{
        {{{Complex(2.6, -0.026)}, 0.005}, {{1.0}, 0.002}}, HalfSpace{{Complex(5.24, -0.34)}}, 60e9};
    const Transmission t = stack_transmission(stack, 1.0);
    CHECK(std::abs(t.te - t.tm) < 1e-14);
}

TEST_CASE("nothing gets through a perfect conductor, and next to nothing through a metal",
          "[transmission]") {
    const Layer sheet{.medium = {Complex(2.6, -0.026)}, .thickness_m = 0.005};
    const Transmission none = stack_transmission({{sheet}, PerfectConductor{}, 60e9}, 0.7);
    CHECK(std::abs(none.te) + std::abs(none.tm) == 0.0);
    const Layer foil{.medium = {Complex(1.0, -1e7)}, .thickness_m = 2e-5};
    CHECK(std::abs(stack_transmission({{foil}, HalfSpace{}, 60e9}, 0.7).te) < 1e-20);
}

TEST_CASE("power is neither made nor lost in a lossless stack", "[transmission]") {
    for (const double cosine : {1.0, 0.7, 0.3, 0.05}) {
        const Stack stack{{{{2.6}, 0.005}, {{1.0}, 0.002}, {{6.3}, 0.01}}, HalfSpace{{3.8}}, 60e9};
        const StackPower power = stack_power(stack, cosine);
        CHECK(std::abs(power.te.absorbed) < 1e-12);
        CHECK(std::abs(power.tm.absorbed) < 1e-12);
    }
}

TEST_CASE("a slab lets as much through from one side as from the other", "[transmission]") {
    std::vector<Layer> layers{{{Complex(2.6, -0.026)}, 0.005},
                              {{Complex(7.5, -0.15)}, 0.003},
                              {{Complex(2.0, -0.3)}, 0.011}};
    const std::vector<Layer> turned(layers.rbegin(), layers.rend());
    for (const double cosine : {1.0, 0.6}) {
        const Transmission down = stack_transmission({layers, HalfSpace{}, 60e9}, cosine);
        const Transmission up = stack_transmission({turned, HalfSpace{}, 60e9}, cosine);
        CHECK(std::abs(down.te - up.te) < 1e-13);
        CHECK(std::abs(down.tm - up.tm) < 1e-13);
    }
}

TEST_CASE("roughness only takes from the coherent power", "[transmission]") {
    const auto absorbed = [](double roughness_m) {
        Stack stack{{{{3.0}, 0.005, roughness_m}}, HalfSpace{}, 60e9};
        std::get<HalfSpace>(stack.backing).roughness_m = roughness_m;
        return stack_power(stack, 0.8).te.absorbed;
    };
    CHECK(std::abs(absorbed(0.0)) < 1e-13);
    CHECK(absorbed(5e-5) > 1e-4);
    CHECK(absorbed(2e-4) > absorbed(5e-5));
}

}  // namespace
}  // namespace specula
