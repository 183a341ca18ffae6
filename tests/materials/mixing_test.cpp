#include "materials/mixing.hpp"

#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

const std::vector<std::pair<std::string, MixingLaw>> laws{
    {"looyenga", MixingLaw::looyenga},
    {"maxwell_garnett", MixingLaw::maxwell_garnett},
    {"bruggeman", MixingLaw::bruggeman},
    {"lichtenecker", MixingLaw::lichtenecker}};
const Complex stone(7.5, -0.08), water(10.9, -19.7), air(1.0, 0.0);

TEST_CASE("the mixing laws give the reference's moist and porous media", "[mixing][reference]") {
    const auto reference = reference_case("M06_mixing");
    const double tolerance = reference.at("tolerance").at("rel");
    for (const auto& point : reference.at("points")) {
        const auto& inp = point.at("inp");
        const bool moist = inp.contains("v");
        const Mix mix{.host = complex_of(inp.at("host_eps")),
                      .inclusion = complex_of(inp.at(moist ? "water_eps" : "inclusion_eps")),
                      .inclusion_fraction = inp.at(moist ? "v" : "porosity")};
        for (const auto& [name, law] : laws) {
            const Complex expected = complex_of(point.at("expect").at(name));
            INFO(name << " " << inp.dump());
            CHECK(std::abs(mixed_permittivity(law, mix) - expected) <
                  tolerance * std::abs(expected));
        }
    }
}

TEST_CASE("nothing of a medium leaves the other, all of it replaces it", "[mixing]") {
    for (const auto& [name, law] : laws) {
        INFO(name);  // 1e-14: a root and its power
        CHECK(std::abs(mixed_permittivity(law, {stone, water, 0.0}) - stone) < 1e-14 * 8.0);
        CHECK(std::abs(mixed_permittivity(law, {stone, water, 1.0}) - water) < 1e-14 * 23.0);
    }
}

TEST_CASE("a medium mixed with itself stays what it is", "[mixing]") {
    for (const auto& [name, law] : laws)
        CHECK(std::abs(mixed_permittivity(law, {water, water, 0.3}) - water) < 1e-13);
}

TEST_CASE("laws on equal terms do not ask which medium is the host", "[mixing]") {
    for (const auto law : {MixingLaw::looyenga, MixingLaw::bruggeman, MixingLaw::lichtenecker}) {
        const Complex one = mixed_permittivity(law, {stone, water, 0.2});
        const Complex other = mixed_permittivity(law, {water, stone, 0.8});
        CHECK(std::abs(one - other) < 1e-13);
    }
}

TEST_CASE("two lossless media mix to a lossless one within Wiener's bounds", "[mixing]") {
    for (const auto& [name, law] : laws)
        for (const double v : {0.01, 0.2, 0.5, 0.8, 0.99}) {
            INFO(name << " " << v);
            const Complex mixed = mixed_permittivity(law, {9.0, 1.0, v});
            CHECK(std::abs(mixed.imag()) < 1e-15);
            CHECK(mixed.real() < 9.0 * (1.0 - v) + v);
            CHECK(mixed.real() > 1.0 / ((1.0 - v) / 9.0 + v));
        }
}

TEST_CASE("for few spheres all laws but Lichtenecker's and Looyenga's agree to first order",
          "[mixing]") {
    const double v = 1e-5;
    const Complex dilute =
        stone + 3.0 * v * stone * (air - stone) / (air + 2.0 * stone);  // Maxwell's own result
    for (const auto law : {MixingLaw::maxwell_garnett, MixingLaw::bruggeman})
        CHECK(std::abs(mixed_permittivity(law, {stone, air, v}) - dilute) < 20.0 * v * v);
}

TEST_CASE("passive media mix to a passive one", "[mixing]") {
    for (const auto& [name, law] : laws)
        for (const Complex host : {stone, air, Complex(2.0, 0.0), Complex(1.0, -30.0)})
            for (double v = 0.0; v <= 1.0; v += 0.05) {
                INFO(name << " " << v);
                const Complex mixed = mixed_permittivity(law, {host, water, v});
                CHECK(mixed.imag() <= 0.0);
                CHECK(mixed.real() >= 1.0 - 1e-12);
            }
}

TEST_CASE("a share outside 0 to 1 and a medium with gain are our own mistakes", "[mixing]") {
    CHECK_THROWS_AS(mixed_permittivity(MixingLaw::looyenga, {stone, air, 1.1}), BrokenPromise);
    CHECK_THROWS_AS(mixed_permittivity(MixingLaw::looyenga, {Complex(2.0, 0.1), air, 0.1}),
                    BrokenPromise);
}

}  // namespace
}  // namespace specula
