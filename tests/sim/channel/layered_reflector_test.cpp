#include <cmath>

#include "sim/channel/reflector.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/sim/plate_scene.hpp"

namespace specula {
namespace {

double degrees_between(Complex a, Complex b) {
    return std::abs(std::arg(a / b)) * 180.0 / pi;
}

Sample rusty(double rust_m) {
    return {.material = "rust", .face = {}, .layers = {{"rust", rust_m}, {"iron", 0.003}}};
}

TEST_CASE("layers come in the order of the sample, with their own faces", "[channel]") {
    const Sample sample{.material = "plexiglass",
                        .face = {},
                        .backing = "chipboard",
                        .layers = {{"plexiglass", 0.005, 1e-6}, {"air", 0.002}}};
    const Stack stack = reflector_of(sample, library())(test_frequency_hz);
    REQUIRE(stack.layers.size() == 2);
    CHECK(stack.layers[0].medium.permittivity.real() == Approx(2.6));
    CHECK(stack.layers[0].roughness_m == 1e-6);
    CHECK(stack.layers[1].medium.permittivity == Complex(1.0, 0.0));
    CHECK(stack.layers[1].thickness_m == 0.002);
    CHECK(std::get<HalfSpace>(stack.backing).medium.permittivity ==
          library().find("chipboard")->at(test_frequency_hz).permittivity);
}

TEST_CASE("one layer is the same reflector, bit by bit, as a sample of that material",
          "[channel]") {
    const Sample plain{.material = "limestone",
                       .face = {},
                       .thickness_m = 0.02,
                       .roughness_m = 2e-5,
                       .permittivity_factor = 1.03,
                       .loss_factor = 0.8};
    Sample layered = plain;
    layered.layers = {{"limestone", 0.02, 2e-5}};
    for (double f_hz = 57e9; f_hz < 64e9; f_hz += 0.7e9)
        for (const double cosine : {1.0, 0.8}) {
            const Reflection one = stack_reflection(reflector_of(plain, library())(f_hz), cosine);
            const Reflection two = stack_reflection(reflector_of(layered, library())(f_hz), cosine);
            CHECK(one.te == two.te);
            CHECK(one.tm == two.tm);
        }
}

TEST_CASE("rust turns the phase of iron by its thickness and takes next to nothing", "[channel]") {
    const Complex bare =
        stack_reflection(reflector_of(rusty(1e-12), library())(test_frequency_hz), 1.0).te;
    for (const double rust_m : {10e-6, 30e-6, 80e-6}) {
        const Complex coated =
            stack_reflection(reflector_of(rusty(rust_m), library())(test_frequency_hz), 1.0).te;
        // A thin film on a mirror is a mirror that far behind its face, whatever the film is.
        const double turn_deg = 2.0 * 360.0 * rust_m * test_frequency_hz / speed_of_light_m_s;
        CHECK(degrees_between(coated, bare) == Approx(turn_deg).epsilon(0.02));
        CHECK(20.0 * std::log10(std::abs(coated / bare)) > -0.02);
    }
}

TEST_CASE("an air gap under plexiglass moves the echo by decibels", "[channel]") {
    const auto level = [&](double gap_m) {
        const Sample sample{.material = "plexiglass",
                            .face = {},
                            .backing = "chipboard",
                            .layers = {{"plexiglass", 0.005}, {"air", gap_m}}};
        return std::abs(
            stack_reflection(reflector_of(sample, library())(test_frequency_hz), 1.0).te);
    };
    CHECK(20.0 * std::abs(std::log10(level(0.002) / level(0.003))) > 2.0);
    // Half a wavelength of air more is the same to the wave.
    const double half_m = 0.5 * speed_of_light_m_s / test_frequency_hz;
    CHECK(level(0.002) == Approx(level(0.002 + half_m)).epsilon(1e-9));
}

TEST_CASE("a board turned by a quarter shows its other grain, by its own angle or by yaw",
          "[channel]") {
    Sample board{.material = "pine", .face = {}, .thickness_m = 0.018};
    const auto reflection = [&](double yaw_rad) {
        return stack_reflection(reflector_of(board, library(), yaw_rad)(test_frequency_hz), 1.0).te;
    };
    const Complex along = reflection(0.0), across = reflection(0.5 * pi);
    CHECK(std::abs(along - across) > 0.02);
    board.grain_rad = 0.5 * pi;
    CHECK(std::abs(reflection(0.0) - across) < 1e-15);
    CHECK(std::abs(reflection(-0.5 * pi) - along) < 1e-15);
}

TEST_CASE("a turned veneer has along and across exchanged", "[channel]") {
    const Sample plywood{.material = "pine",
                         .face = {},
                         .layers = {{"pine", 0.002}, {"pine", 0.002, 0.0, true}, {"pine", 0.002}}};
    const Stack stack = reflector_of(plywood, library())(test_frequency_hz);
    const Grained &outer = *stack.layers[0].grain, &inner = *stack.layers[1].grain;
    CHECK(inner.along.permittivity == outer.across.permittivity);
    CHECK(inner.across.permittivity == outer.along.permittivity);
}

TEST_CASE("without a grain yaw changes nothing", "[channel]") {
    const Sample sample{.material = "wood", .face = {}, .thickness_m = 0.018};
    const Reflection straight =
        stack_reflection(reflector_of(sample, library())(test_frequency_hz), 0.9);
    const Reflection turned =
        stack_reflection(reflector_of(sample, library(), 1.0)(test_frequency_hz), 0.9);
    CHECK(straight.te == turned.te);
    CHECK(straight.tm == turned.tm);
}

}  // namespace
}  // namespace specula
