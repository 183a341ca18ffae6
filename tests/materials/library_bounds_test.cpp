#include <cmath>

#include "materials/library.hpp"
#include "materials/transmission.hpp"
#include "materials/validity.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

/// All frequencies, angles and grains for one material.
template <typename Check>
void everywhere(const Material& material, const Check& check) {
    for (double f_hz = 57e9; f_hz <= 64e9; f_hz += 0.5e9) {
        const Grained grained = material.grained(f_hz);
        for (const Electrics& medium : {material.at(f_hz), grained.along, grained.across})
            for (double incidence_deg = 0.0; incidence_deg <= 85.0; incidence_deg += 5.0)
                check(medium, f_hz, std::cos(incidence_deg * pi / 180.0));
    }
}

TEST_CASE("no material of the library gives power away", "[library]") {
    for (const std::string& name : library().names()) {
        INFO(name);
        double least = 0.0, most = 0.0;
        everywhere(*library().find(name), [&](const Electrics& medium, double f_hz, double cosine) {
            REQUIRE(medium.permittivity.real() >= 1.0);
            REQUIRE(medium.permittivity.imag() <= 0.0);
            for (const double thickness_m : {0.0, 1e-4, 5e-3, 0.02}) {
                Stack stack{{}, HalfSpace{medium}, f_hz};
                if (thickness_m > 0.0)
                    stack = {{{.medium = medium, .thickness_m = thickness_m}}, HalfSpace{}, f_hz};
                const StackPower power = stack_power(stack, cosine);
                for (const PowerShares& shares : {power.te, power.tm}) {
                    least =
                        std::min({least, shares.reflected, shares.transmitted, shares.absorbed});
                    most = std::max({most, shares.reflected, shares.transmitted, shares.absorbed});
                }
            }
        });
        CHECK(least > -1e-11);  // rounding; 1e-12 at grazing incidence on a metal
        CHECK(most < 1.0 + 1e-11);
    }
}

TEST_CASE("every material says what it is, where its numbers come from and where they hold",
          "[library]") {
    CHECK(library().names().size() >= 30);
    for (const std::string& name : library().names()) {
        INFO(name);
        const Material& material = *library().find(name);
        CHECK(material.title.size() > 2);
        CHECK(material.title.size() <= 46);  // the width of its column in `specula list`
        CHECK(material.source.size() > 20);
        CHECK(name.size() <= 18);
        CHECK(material.valid_max_hz >= 40e9);
        for (const NumberOrigin& number : material.numbers) CHECK(number.source.size() > 5);
    }
}

TEST_CASE("every file says how firm its numbers are", "[library]") {
    for (const std::string& name : library().names()) {
        Section section = Section::read(SPECULA_SOURCE_DIR "/materials/library/" + name + ".toml");
        INFO(name);
        CHECK(section.has("evidence"));
        CHECK(section.has("group"));
    }
}

TEST_CASE("only fits that end below 64 GHz are extrapolated, and they are known", "[library]") {
    std::vector<std::string> extrapolated;
    for (const std::string& name : library().names())
        if (!band_warnings(*library().find(name), {57e9, 64e9}).empty())
            extrapolated.push_back(name);
    CHECK(extrapolated == std::vector<std::string>{"brick", "marble", "plywood", "vinyl_tile"});
}

TEST_CASE("building materials are those of ITU-R P.2040", "[library][reference]") {
    const auto reference = reference_case("M02_itu_p2040");
    const double tolerance = reference.at("tolerance").at("rel");
    int n_found = 0;
    for (const auto& point : reference.at("points")) {
        const std::string name = point.at("inp").at("material");
        if (name == "metal") continue;  // a stand-in that the library has real metals for
        INFO(name);
        const Material* material = library().find(name);
        REQUIRE(material != nullptr);
        const Complex found = material->at(point.at("inp").at("f_hz")).permittivity;
        const Complex expected = complex_of(point.at("expect").at("eps"));
        CHECK(std::abs(found - expected) < tolerance * std::abs(expected));
        CHECK(material->evidence == Evidence::recommendation);
        ++n_found;
    }
    CHECK(n_found == 24);
}

TEST_CASE("water, skin and muscle of the library are those of the literature",
          "[library][reference]") {
    const auto reference = reference_case("M07_debye");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        if (inp.contains("T_C") && inp.at("T_C") != 20.0) continue;
        const Complex expected = complex_of(point.at("expect").at("eps"));
        const Complex found = library().find(inp.at("medium"))->at(inp.at("f_hz")).permittivity;
        CHECK(std::abs(found - expected) < 1e-6 * std::abs(expected));
    }
}

}  // namespace
}  // namespace specula
