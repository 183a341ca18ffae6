#include <cmath>

#include "materials/models/cole_cole.hpp"
#include "materials/models/debye.hpp"
#include "materials/models/water.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

Section parse(const std::string& text) {
    return Section::parse(text, "x.toml");
}

const ColeCole skin{.high_permittivity = 4.0,
                    .poles = {{32.0, 7.234e-12, 0.0}, {1100.0, 32.481e-9, 0.2}},
                    .conductivity_s_m = 0.0002};
const ColeCole muscle{.high_permittivity = 4.0,
                      .poles = {{50.0, 7.234e-12, 0.1},
                                {7000.0, 353.68e-9, 0.1},
                                {1.2e6, 318.31e-6, 0.1},
                                {2.5e7, 2.274e-3, 0.0}},
                      .conductivity_s_m = 0.2};

TEST_CASE("water, skin and muscle are those of the reference", "[relaxation][reference]") {
    const auto reference = reference_case("M07_debye");
    const double tolerance = reference.at("tolerance").at("rel");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        const std::string medium = inp.at("medium");
        const double f_hz = inp.at("f_hz");
        const Complex found =
            medium == "water" ? Water{inp.at("T_C").get<double>() + 273.15}.at(f_hz).permittivity
                              : (medium == "muscle" ? muscle : skin).at(f_hz).permittivity;
        const Complex expected = complex_of(point.at("expect").at("eps"));
        INFO(inp.dump());
        CHECK(std::abs(found - expected) < tolerance * std::abs(expected));
    }
}

TEST_CASE("a relaxation is static far below it and gone far above", "[relaxation]") {
    const Debye model{.static_permittivity = 80.0, .high_permittivity = 5.0, .relaxation_s = 9e-12};
    CHECK(std::abs(model.at(1e3).permittivity - 80.0) < 1e-4);   // 75 * w tau
    CHECK(std::abs(model.at(1e17).permittivity - 5.0) < 1e-4);  // 75 / (w tau)
}

TEST_CASE("the loss of a relaxation peaks at its own frequency, at half the step", "[relaxation]") {
    const Debye model{.static_permittivity = 80.0, .high_permittivity = 5.0, .relaxation_s = 9e-12};
    const double peak_hz = 1.0 / (two_pi * model.relaxation_s);
    CHECK(-model.at(peak_hz).permittivity.imag() == Approx(37.5));
    CHECK(-model.at(0.9 * peak_hz).permittivity.imag() < 37.5);
    CHECK(-model.at(1.1 * peak_hz).permittivity.imag() < 37.5);
}

TEST_CASE("ions conduct as a metal does", "[relaxation]") {
    const Debye still{.static_permittivity = 3.0, .high_permittivity = 3.0, .relaxation_s = 1e-12,
                      .conductivity_s_m = 2.0};
    const double expected = 2.0 / (two_pi * 60e9 * vacuum_permittivity_f_m);
    CHECK(-still.at(60e9).permittivity.imag() == Approx(expected));
}

TEST_CASE("without spread, Cole and Cole's relaxation is Debye's", "[relaxation]") {
    const Debye debye{.static_permittivity = 36.0, .high_permittivity = 4.0,
                      .relaxation_s = 7.234e-12, .conductivity_s_m = 0.3};
    const ColeCole cole{.high_permittivity = 4.0, .poles = {{32.0, 7.234e-12, 0.0}},
                        .conductivity_s_m = 0.3};
    for (const double f_hz : {1e9, 20e9, 60e9, 300e9})
        CHECK(std::abs(debye.at(f_hz).permittivity - cole.at(f_hz).permittivity) < 1e-13 * 40.0);
}

TEST_CASE("a double relaxation with one step is a single one", "[relaxation]") {
    const DoubleDebye twice{.static_permittivity = 80.0, .middle_permittivity = 5.0,
                            .high_permittivity = 5.0, .slow_relaxation_hz = 17e9};
    const Debye once{.static_permittivity = 80.0, .high_permittivity = 5.0,
                     .relaxation_s = 1.0 / (two_pi * 17e9)};
    CHECK(std::abs(twice.at(60e9).permittivity - once.at(60e9).permittivity) < 1e-12);
}

TEST_CASE("water is lossier and faster the warmer it is", "[relaxation]") {
    double slow_hz = 0.0, loss = 0.0;
    for (const double celsius : {-10.0, 0.0, 10.0, 20.0, 30.0, 40.0}) {
        const Water water{celsius + 273.15};
        CHECK(water.relaxations().slow_relaxation_hz > slow_hz);
        CHECK(-water.at(60e9).permittivity.imag() > loss);
        slow_hz = water.relaxations().slow_relaxation_hz;
        loss = -water.at(60e9).permittivity.imag();
    }
}

TEST_CASE("a file gives the relaxation times in its own unit", "[relaxation]") {
    Section debye = parse(
        "static_permittivity = 80\nhigh_permittivity = 5\nrelaxation_ps = 9\n"
        "conductivity_s_per_m = 0.1\n");
    const Debye read = Debye::read(debye);
    CHECK(read.relaxation_s == Approx(9e-12));
    CHECK(read.conductivity_s_m == 0.1);
    Section cole = parse(
        "high_permittivity = 4\n[[pole]]\nstrength = 32\nrelaxation_ps = 7.234\n"
        "[[pole]]\nstrength = 1100\nrelaxation_ns = 32.481\nspread = 0.2\n");
    const ColeCole poles = ColeCole::read(cole);
    REQUIRE(poles.poles.size() == 2);
    CHECK(poles.poles[1].relaxation_s == Approx(32.481e-9));
    CHECK(poles.poles[0].spread == 0.0);
    CHECK(poles.conductivity_s_m == 0.0);
    Section warm = parse("temperature_k = 303.15");
    CHECK(Water::read(warm).temperature_k == 303.15);
}

TEST_CASE("a permittivity that rises with frequency is refused", "[relaxation]") {
    Section section =
        parse("static_permittivity = 3\nhigh_permittivity = 5\nrelaxation_ps = 9\n");
    CHECK(message_of([&] { return Debye::read(section); }) ==
          "x.toml:1: static_permittivity = 3: is out of range; give a value at least 5");
    Section twice = parse(
        "static_permittivity = 80\nmiddle_permittivity = 6\nhigh_permittivity = 5\n"
        "slow_relaxation_ghz = 18\nfast_relaxation_ghz = 17\n");
    CHECK(message_of([&] { return DoubleDebye::read(twice); }) ==
          "x.toml:5: fast_relaxation_ghz = 17: is out of range; give a value above 18 ghz");
}

TEST_CASE("tissue without a relaxation is refused", "[relaxation]") {
    Section section = parse("high_permittivity = 4\n");
    CHECK(message_of([&] { return ColeCole::read(section); }).find("describe each as [[pole]]") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
