#include "sim/speckle_echo.hpp"

#include <cmath>

#include "sim/clutter.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/sim/deviation.hpp"

namespace specula {
namespace {

Scene stone(double roughness_m, double correlation_m) {
    Scene scene;
    scene.radar.pattern = PatchPattern{};
    scene.radar.rx = {ReceiveChannel{}};
    scene.sample.material = "limestone";
    scene.sample.face = {.size_x_m = 0.3, .size_y_m = 0.3};
    scene.sample.thickness_m = 0.02;
    scene.sample.roughness_m = roughness_m;
    scene.sample.correlation_m = correlation_m;
    return scene;
}

double mean_power(const MeanEcho& echo) {
    double sum = 0.0;
    for (std::size_t i = 0; i < echo.coherent.h.size(); ++i)
        sum += std::norm(echo.coherent.h[i]) + echo.diffuse_power[i];
    return sum / static_cast<double>(echo.coherent.h.size());
}

double level_db(Scene scene, double tilt_deg) {
    scene.pose.sample.about_y_rad = tilt_deg * pi / 180.0;
    return 10.0 * std::log10(mean_power(mean_echo(scene, library()))) -
           20.0 * std::log10(mirror_transfer(scene.radar, scene.pose.height_m));
}

TEST_CASE("rough limestone of 30 cm keeps its mean level when it is tilted", "[speckle]") {
    // Levels over a mirror at 0 and 15 degrees, from an independent model of antenna, plate and
    // Kirchhoff's series with another limestone, band and edge model: 1.5 dB.
    CHECK(level_db(stone(5e-4, 4e-3), 0.0) == Approx(-7.8).margin(1.5));
    CHECK(level_db(stone(5e-4, 4e-3), 15.0) == Approx(-8.4).margin(1.5));
    CHECK(level_db(stone(8e-4, 5e-3), 0.0) == Approx(-8.7).margin(1.5));
    CHECK(level_db(stone(8e-4, 5e-3), 15.0) == Approx(-9.7).margin(1.5));
}

TEST_CASE("a split slab of 15 cm survives the tilt that blinds a honed one", "[speckle]") {
    const auto lost_db = [](double roughness_m, double correlation_m) {
        Scene scene = stone(roughness_m, correlation_m);
        scene.sample.face = {.size_x_m = 0.15, .size_y_m = 0.15};
        return level_db(scene, 10.0) - level_db(scene, 0.0);
    };
    CHECK(lost_db(2e-5, 2e-3) < -6.0);
    CHECK(lost_db(8e-4, 5e-3) > -2.5);
}

TEST_CASE("the echoes of many pieces have the mean power that is foretold", "[speckle]") {
    Scene scene = stone(1.5e-4, 3e-3);
    scene.sample.face = {.size_x_m = 0.1, .size_y_m = 0.1};
    const MeanEcho mean = mean_echo(scene, library());
    const std::size_t middle = mean.coherent.h.size() / 2;
    double sum = 0.0;
    Complex field = 0.0;
    for (std::uint64_t piece = 0; piece < 60; ++piece) {
        scene.sample.piece = piece;
        const Complex h = echo_channel(scene, library()).h[middle];
        sum += std::norm(h - mean.coherent.h[middle]);
        field += h;
    }
    // Exponential powers: 13 % for 60 pieces, three times that; their mean field has 1/60 of it.
    CHECK(sum / 60.0 == Approx(mean.diffuse_power[middle]).epsilon(0.4));
    CHECK(std::abs(field / 60.0 - mean.coherent.h[middle]) <
          3.0 * std::sqrt(mean.diffuse_power[middle] / 60.0));
}

TEST_CASE("a piece's echo is its own, and only the statistical solver gives it", "[speckle]") {
    Scene scene = stone(1.5e-4, 3e-3);
    scene.sample.face = {.size_x_m = 0.1, .size_y_m = 0.1};
    const Channel first = echo_channel(scene, library());
    CHECK(echo_channel(scene, library()).h == first.h);
    scene.sample.piece = 2;
    CHECK(echo_channel(scene, library()).h != first.h);
    scene.solver.roughness = Solver::Roughness::coherent;
    const MeanEcho mean = mean_echo(scene, library());
    CHECK(echo_channel(scene, library()).h == mean.coherent.h);
    CHECK(mean.diffuse_power[0] == 0.0);
}

TEST_CASE("faces too smooth for the accuracy asked for are left out, buried ones are found",
          "[speckle]") {
    Sample sample = stone(1e-6, 1e-3).sample;
    const FrequencyComb comb{.first_hz = 58e9, .step_hz = 1e9, .n = 4};
    const auto found = [&](double accuracy_db) {
        const Reflector reflector = reflector_of(sample, library());
        return rough_layers({.body = 0, .reflector = reflector}, comb, accuracy_db);
    };
    CHECK(found(0.1).empty());
    CHECK(found(1e-5).size() == 1);
    sample.layers = {
        {.material = "plexiglass", .thickness_m = 0.003},
        {.material = "limestone", .thickness_m = 0.02, .roughness_m = 2e-4, .correlation_m = 4e-3}};
    REQUIRE(found(0.1).size() == 1);
    CHECK(found(0.1)[0].face == 1);
    CHECK(found(0.1)[0].correlation_m == 4e-3);
}

TEST_CASE("heights that break the theory are named", "[speckle]") {
    const FrequencyBand band{58e9, 62e9};
    CHECK(roughness_warnings(stone(2.5e-5, 1e-3).sample, band).empty());  // small
    CHECK(roughness_warnings(stone(3e-4, 5e-3).sample, band).empty());    // long
    CHECK(roughness_warnings(stone(3e-4, 1e-3).sample, band).at(0).find("slope") !=
          std::string::npos);
    CHECK(roughness_warnings(stone(2e-4, 1.5e-3).sample, band).at(0).find("half a wavelength") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
