#include "materials/models/debye.hpp"

#include "materials/models/double_debye.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/section_of.hpp"

namespace specula {
namespace {

const Debye liquid{.static_permittivity = 80.0, .high_permittivity = 5.0, .relaxation_s = 9e-12};

TEST_CASE("a relaxation is static far below it and gone far above", "[debye]") {
    CHECK(std::abs(liquid.at(1e3).permittivity - 80.0) < 1e-4);  // 75 w tau
    CHECK(std::abs(liquid.at(1e17).permittivity - 5.0) < 1e-4);  // 75 / (w tau)
}

TEST_CASE("the loss of a relaxation peaks at its own frequency, at half the step", "[debye]") {
    const double peak_hz = 1.0 / (two_pi * liquid.relaxation_s);
    CHECK(-liquid.at(peak_hz).permittivity.imag() == Approx(37.5));
    CHECK(-liquid.at(0.9 * peak_hz).permittivity.imag() < 37.5);
    CHECK(-liquid.at(1.1 * peak_hz).permittivity.imag() < 37.5);
}

TEST_CASE("ions conduct as a metal does", "[debye]") {
    const Debye still{.static_permittivity = 3.0,
                      .high_permittivity = 3.0,
                      .relaxation_s = 1e-12,
                      .conductivity_s_m = 2.0};
    const double expected = 2.0 / (two_pi * 60e9 * vacuum_permittivity_f_m);
    CHECK(-still.at(60e9).permittivity.imag() == Approx(expected));
}

TEST_CASE("a double relaxation with one step is a single one", "[debye]") {
    const DoubleDebye twice{.static_permittivity = 80.0,
                            .middle_permittivity = 5.0,
                            .high_permittivity = 5.0,
                            .slow_relaxation_hz = 17e9};
    const Debye once{.static_permittivity = 80.0,
                     .high_permittivity = 5.0,
                     .relaxation_s = 1.0 / (two_pi * 17e9)};
    CHECK(std::abs(twice.at(60e9).permittivity - once.at(60e9).permittivity) < 1e-12);
}

TEST_CASE("a file gives the relaxation time in its own unit", "[debye]") {
    Section section = section_of(
        "static_permittivity = 80\nhigh_permittivity = 5\nrelaxation_ps = 9\n"
        "conductivity_s_per_m = 0.1\n");
    const Debye read = Debye::read(section);
    CHECK(read.relaxation_s == Approx(9e-12));
    CHECK(read.conductivity_s_m == 0.1);
}

TEST_CASE("a permittivity that rises with frequency is refused", "[debye]") {
    Section section =
        section_of("static_permittivity = 3\nhigh_permittivity = 5\nrelaxation_ps = 9\n");
    CHECK(message_of([&] { return Debye::read(section); }) ==
          "x.toml:1: static_permittivity = 3: is out of range; give a value at least 5");
    Section twice = section_of(
        "static_permittivity = 80\nmiddle_permittivity = 6\nhigh_permittivity = 5\n"
        "slow_relaxation_ghz = 18\nfast_relaxation_ghz = 17\n");
    CHECK(message_of([&] { return DoubleDebye::read(twice); }) ==
          "x.toml:5: fast_relaxation_ghz = 17: is out of range; give a value above 18 ghz");
}

}  // namespace
}  // namespace specula
