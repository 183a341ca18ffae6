#include "sim/limits.hpp"

#include "scenes/catalogue.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/project_catalogue.hpp"

namespace specula {
namespace {

Scene scene_of(const std::string& material, double size_m) {
    Scene scene;
    scene.radar = read_radar(SPECULA_SOURCE_DIR "/scenes/radars/iwrl6432boost.toml");
    scene.sample.material = material;
    scene.sample.face = {.size_x_m = size_m, .size_y_m = 2.0 * size_m};
    return scene;
}

std::string limits_text(const Scene& scene) {
    std::string text;
    for (const std::string& line : optics_limits(scene, catalogue().materials)) text += line + "\n";
    return text;
}

std::string echo_text(const Scene& scene) {
    const Channel echo = echo_channel(scene, catalogue().materials);
    std::string text;
    for (const std::string& line : echo_limits(scene, catalogue().materials, echo))
        text += line + "\n";
    return text;
}

// At the middle of the chirp, 59.6 GHz, 3 wavelengths are 15.1 mm and 20 are 100.6 mm.

TEST_CASE("a sample below three wavelengths is told, whatever it is made of", "[limits]") {
    CHECK(limits_text(scene_of("aluminium", 0.016)).empty());
    CHECK(limits_text(scene_of("aluminium", 0.014)).find("the sample is 2.8 wavelengths wide") !=
          std::string::npos);
    CHECK(limits_text(scene_of("plexiglass", 0.014)).find("no error is known") !=
          std::string::npos);
}

TEST_CASE("a dielectric below twenty wavelengths is told with its error, a metal is not",
          "[limits]") {
    CHECK(limits_text(scene_of("plexiglass", 0.103)).empty());
    CHECK(limits_text(scene_of("plexiglass", 0.098)).find("up to 1.2 dB") != std::string::npos);
    CHECK(limits_text(scene_of("aluminium", 0.098)).empty());
}

TEST_CASE("edge currents asked of a dielectric are told to be left out", "[limits]") {
    Scene scene = scene_of("plexiglass", 0.3);
    CHECK(limits_text(scene).empty());
    scene.solver.edge_currents = true;
    CHECK(limits_text(scene).find("edges are left out") != std::string::npos);
    Scene metal = scene_of("aluminium", 0.3);
    metal.solver.edge_currents = true;
    CHECK(limits_text(metal).empty());
}

TEST_CASE("an echo 15 dB below an endless sheet's is told, weak materials are not", "[limits]") {
    Scene scene = scene_of("aluminium", 0.1);
    CHECK(echo_text(scene).empty());
    scene.pose.sample.about_y_rad = 0.2;  // the mirror point lies 9 cm off, the rim 5
    CHECK(echo_text(scene).find("edges count") != std::string::npos);
    CHECK(echo_text(scene).find("up to 1.5 dB") != std::string::npos);
    scene.solver.edge_currents = true;
    CHECK(echo_text(scene).find("0.5 dB even with edge_currents") != std::string::npos);

    CHECK(echo_text(scene_of("wood", 0.3)).empty());  // 15 dB below metal, but whole
}

TEST_CASE("an echo of nothing is told as such and gives no number", "[limits]") {
    Scene scene = scene_of("aluminium", 0.1);
    scene.pose.sensor.about_y_rad = 3.0;  // looks up
    CHECK(echo_text(scene) == "the radar receives nothing from the sample\n");
}

}  // namespace
}  // namespace specula
