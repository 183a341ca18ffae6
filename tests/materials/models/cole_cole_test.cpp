#include "materials/models/cole_cole.hpp"

#include "materials/models/debye.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/reference_case.hpp"
#include "tests/section_of.hpp"

namespace specula {
namespace {

const ColeCole skin{.high_permittivity = 4.0,
                    .poles = {{32.0, 7.234e-12, 0.0}, {1100.0, 32.481e-9, 0.2}},
                    .conductivity_s_m = 0.0002};
const ColeCole muscle{.high_permittivity = 4.0,
                      .poles = {{50.0, 7.234e-12, 0.1},
                                {7000.0, 353.68e-9, 0.1},
                                {1.2e6, 318.31e-6, 0.1},
                                {2.5e7, 2.274e-3, 0.0}},
                      .conductivity_s_m = 0.2};

TEST_CASE("skin and muscle are those of the reference", "[cole_cole][reference]") {
    const auto reference = reference_case("M07_debye");
    const double tolerance = reference.at("tolerance").at("rel");
    int n_tissues = 0;
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        if (inp.at("medium") == "water") continue;
        ++n_tissues;
        INFO(inp.dump());
        const double f_hz = inp.at("f_hz");
        const Complex found = (inp.at("medium") == "muscle" ? muscle : skin).at(f_hz).permittivity;
        const Complex expected = complex_of(expect.at("eps"));
        CHECK(std::abs(found - expected) < tolerance * std::abs(expected));
        CHECK(-found.imag() * two_pi * f_hz * vacuum_permittivity_f_m ==
              Approx(expect.at("sigma_S_per_m").get<double>()).epsilon(tolerance));
    }
    CHECK(n_tissues == 6);
}

TEST_CASE("without spread, Cole and Cole's relaxation is Debye's", "[cole_cole]") {
    const Debye debye{.static_permittivity = 36.0,
                      .high_permittivity = 4.0,
                      .relaxation_s = 7.234e-12,
                      .conductivity_s_m = 0.3};
    const ColeCole cole{
        .high_permittivity = 4.0, .poles = {{32.0, 7.234e-12, 0.0}}, .conductivity_s_m = 0.3};
    for (const double f_hz : {1e9, 20e9, 60e9, 300e9})
        CHECK(std::abs(debye.at(f_hz).permittivity - cole.at(f_hz).permittivity) < 1e-13 * 40.0);
}

TEST_CASE("spread flattens a relaxation and leaves its middle where it is", "[cole_cole]") {
    const double middle_hz = 1.0 / (two_pi * 7.234e-12);
    double loss = 20.0;
    for (const double spread : {0.1, 0.3, 0.6}) {
        const ColeCole cole{.high_permittivity = 4.0, .poles = {{32.0, 7.234e-12, spread}}};
        const Complex middle = cole.at(middle_hz).permittivity;
        CHECK(middle.real() == Approx(4.0 + 16.0));  // half the step, whatever the spread
        CHECK(-middle.imag() < loss);
        loss = -middle.imag();
    }
}

TEST_CASE("each pole has a relaxation time in its own unit", "[cole_cole]") {
    Section section = section_of(
        "high_permittivity = 4\n[[pole]]\nstrength = 32\nrelaxation_ps = 7.234\n"
        "[[pole]]\nstrength = 1100\nrelaxation_ns = 32.481\nspread = 0.2\n");
    const ColeCole model = ColeCole::read(section);
    REQUIRE(model.poles.size() == 2);
    CHECK(model.poles[1].relaxation_s == Approx(32.481e-9));
    CHECK(model.poles[0].spread == 0.0);
    CHECK(model.conductivity_s_m == 0.0);
}

TEST_CASE("tissue without a relaxation is refused", "[cole_cole]") {
    Section section = section_of("high_permittivity = 4\n");
    CHECK(message_of([&] { return ColeCole::read(section); }).find("describe each as [[pole]]") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
