#include "materials/models/water.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

TEST_CASE("water of 0 to 30 degrees is the reference's", "[water][reference]") {
    const auto reference = reference_case("M07_debye");
    const double tolerance = reference.at("tolerance").at("rel");
    int n_waters = 0;
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        if (inp.at("medium") != "water") continue;
        ++n_waters;
        INFO(inp.dump());
        const Complex found =
            Water{inp.at("T_C").get<double>() + 273.15}.at(inp.at("f_hz")).permittivity;
        const Complex expected = complex_of(point.at("expect").at("eps"));
        CHECK(std::abs(found - expected) < tolerance * std::abs(expected));
    }
    CHECK(n_waters == 9);
}

TEST_CASE("water is lossier at 60 GHz and relaxes faster the warmer it is", "[water]") {
    double slow_hz = 0.0, loss = 0.0;
    for (const double celsius : {-10.0, 0.0, 10.0, 20.0, 30.0, 40.0}) {
        const Water water{celsius + 273.15};
        CHECK(water.relaxations().slow_relaxation_hz > slow_hz);
        CHECK(-water.at(60e9).permittivity.imag() > loss);
        slow_hz = water.relaxations().slow_relaxation_hz;
        loss = -water.at(60e9).permittivity.imag();
    }
}

TEST_CASE("standing water has its textbook permittivity", "[water]") {
    CHECK(Water{298.15}.at(1e6).permittivity.real() == Approx(78.4).margin(0.3));  // CRC: 78.4
}

TEST_CASE("the temperature is in kelvin, of liquid water, and 20 degrees by default", "[water]") {
    Section warm = Section::parse("temperature_k = 303.15", "x.toml");
    CHECK(Water::read(warm).temperature_k == 303.15);
    Section none = Section::parse("", "x.toml");
    CHECK(Water::read(none).temperature_k == 293.15);
    Section celsius = Section::parse("temperature_k = 20", "x.toml");
    CHECK(message_of([&] { return Water::read(celsius); }).find("at least 253.15 k") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
