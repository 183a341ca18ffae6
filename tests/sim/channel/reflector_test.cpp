#include "sim/channel/reflector.hpp"

#include "sim/core/expect.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

Sample sample_of(const std::string& material) {
    Sample sample;
    sample.material = material;
    return sample;
}

TEST_CASE("a sample as the library has it is the library's material", "[channel]") {
    for (const std::string& name : library().names()) {
        Sample sample = sample_of(name);
        sample.thickness_m = 0.007;
        sample.roughness_m = 2e-5;
        const Stack stack = reflector_of(sample, library())(test_frequency_hz);
        const Electrics expected = library().find(name)->at(test_frequency_hz);
        REQUIRE(stack.layers.size() == 1);
        CHECK(std::abs(stack.layers[0].medium.permittivity - expected.permittivity) <
              1e-14 * std::abs(expected.permittivity));  // one division and product
        CHECK(stack.layers[0].medium.permeability == expected.permeability);
        CHECK(stack.layers[0].thickness_m == 0.007);
        CHECK(stack.layers[0].roughness_m == 2e-5);
        CHECK(stack.frequency_hz == test_frequency_hz);
    }
}

TEST_CASE("a piece's permittivity and loss tangent vary apart", "[channel]") {
    const Complex nominal = library().find("wood")->at(test_frequency_hz).permittivity;
    const auto medium = [&](double permittivity_factor, double loss_factor) {
        Sample sample = sample_of("wood");
        sample.permittivity_factor = permittivity_factor;
        sample.loss_factor = loss_factor;
        return reflector_of(sample, library())(test_frequency_hz).layers[0].medium.permittivity;
    };
    const auto loss_tangent = [](Complex eps) { return -eps.imag() / eps.real(); };
    CHECK(medium(1.1, 1.0).real() == Approx(1.1 * nominal.real()));
    CHECK(loss_tangent(medium(1.1, 1.0)) == Approx(loss_tangent(nominal)));
    CHECK(medium(1.0, 2.0).real() == Approx(nominal.real()));
    CHECK(loss_tangent(medium(1.0, 2.0)) == Approx(2.0 * loss_tangent(nominal)));
}

TEST_CASE("a metal is not varied: its permittivity is its conductivity", "[channel]") {
    Sample sample = sample_of("iron");
    sample.permittivity_factor = 1.5;
    sample.loss_factor = 3.0;
    const Stack stack = reflector_of(sample, library())(test_frequency_hz);
    CHECK(stack.layers[0].medium.permittivity ==
          library().find("iron")->at(test_frequency_hz).permittivity);
}

TEST_CASE("behind the sample stands air, a mirror, or a material", "[channel]") {
    const auto backing = [](const std::string& name) {
        Sample sample = sample_of("wood");
        sample.backing = name;
        return reflector_of(sample, library())(test_frequency_hz).backing;
    };
    CHECK(std::get<HalfSpace>(backing("air")).medium.permittivity == Complex(1.0, 0.0));
    CHECK(std::holds_alternative<PerfectConductor>(backing("metal")));
    CHECK(std::get<HalfSpace>(backing("limestone")).medium.permittivity ==
          library().find("limestone")->at(test_frequency_hz).permittivity);
}

TEST_CASE("a reflector outlives the library it was made from", "[channel]") {
    Reflector reflector;
    {
        const Library gone(SPECULA_SOURCE_DIR "/materials/library");
        Sample sample = sample_of("wood");
        sample.backing = "limestone";
        reflector = reflector_of(sample, gone);
    }
    CHECK(reflector(test_frequency_hz).layers[0].medium.permittivity.real() > 1.5);
}

TEST_CASE("a name that the library does not hold is our own mistake", "[channel]") {
    Sample sample = sample_of("cheese");
    CHECK_THROWS_AS(reflector_of(sample, library()), BrokenPromise);
    sample = sample_of("wood");
    sample.backing = "cheese";
    CHECK_THROWS_AS(reflector_of(sample, library()), BrokenPromise);
}

}  // namespace
}  // namespace specula
