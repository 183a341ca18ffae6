#include "materials/models/power_law.hpp"

#include <map>

#include "materials/library.hpp"
#include "materials/models/conductive.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

// ITU-R P.2040-3, table 3: a, b, c, d.
const std::map<std::string, PowerLaw> table_3{
    {"concrete", {5.24, 0.0, 0.0462, 0.7822}},     {"plasterboard", {2.73, 0.0, 0.0085, 0.9395}},
    {"wood", {1.99, 0.0, 0.0047, 1.0718}},         {"glass", {6.31, 0.0, 0.0036, 1.3394}},
    {"chipboard", {2.58, 0.0, 0.0217, 0.7800}},    {"ceiling_board", {1.48, 0.0, 0.0011, 1.0750}},
    {"marble", {7.074, 0.0, 0.0055, 0.9262}},      {"floorboard", {3.66, 0.0, 0.0044, 1.3515}},
};

TEST_CASE("building materials have the permittivity that the reference says",
          "[power law][reference]") {
    const auto reference = reference_case("M02_itu_p2040");
    const double tolerance = reference.at("tolerance").at("rel");
    for (const auto& point : reference.at("points")) {
        const std::string name = point.at("inp").at("material");
        const double f_hz = point.at("inp").at("f_hz");
        const Complex expected = complex_of(point.at("expect").at("eps"));
        const Complex found = name == "metal" ? Conductive{.conductivity_s_m = 1e7}.at(f_hz).permittivity
                                              : table_3.at(name).at(f_hz).permittivity;
        INFO(name << " at " << f_hz);
        CHECK(found.real() == Approx(expected.real()).epsilon(tolerance));
        CHECK(found.imag() == Approx(expected.imag()).epsilon(tolerance));
    }
}

TEST_CASE("the library's wood is that of the recommendation", "[power law][reference]") {
    const Library library(SPECULA_SOURCE_DIR "/materials/library");
    const auto reference = reference_case("M02_itu_p2040");
    for (const auto& point : reference.at("points")) {
        if (point.at("inp").at("material") != "wood") continue;
        const Complex found = library.find("wood")->at(point.at("inp").at("f_hz")).permittivity;
        CHECK(std::abs(found - complex_of(point.at("expect").at("eps"))) < 1e-6);
    }
}

TEST_CASE("at 1 GHz the coefficients are the material itself", "[power law]") {
    const Electrics at_one = PowerLaw{.a = 3.0, .b = 0.7, .c = 0.05, .d = 1.3}.at(1e9);
    CHECK(at_one.permittivity.real() == Approx(3.0));
    // sigma / (w eps0) with 0.05 S/m: eps0 w = 0.0556325 S/m at 1 GHz.
    CHECK(at_one.permittivity.imag() == Approx(-0.05 / 0.0556325).epsilon(1e-6));
    CHECK(at_one.permeability == 1.0);
}

}  // namespace
}  // namespace specula
