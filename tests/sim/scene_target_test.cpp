#include "sim/scene_target.hpp"

#include "materials/transmission.hpp"
#include "sim/core/constants.hpp"
#include "sim/simulate.hpp"
#include "tests/check.hpp"
#include "tests/project_library.hpp"
#include "tests/sim/deviation.hpp"

namespace specula {
namespace {

SceneObject plate_at(double z_m, const std::string& material, double size_m) {
    SceneObject object;
    object.matter.material = material;
    object.matter.face = {.size_x_m = size_m, .size_y_m = size_m};
    object.own_placement.shift_m = {0.0, 0.0, z_m};
    return object;
}

Scene scene_of(const std::string& material) {
    Scene scene;
    scene.radar.pattern = PatchPattern{};
    scene.sample.material = material;
    scene.sample.face = {.size_x_m = 0.2, .size_y_m = 0.2};
    return scene;
}

/// In the middle of the band.
Complex echo(const Scene& scene) {
    const Channel channel = echo_channel(scene, library());
    return channel.of_rx(0)[channel.n_frequencies / 2];
}

bool opaque(const Sample& sample) {
    return is_opaque(sample, reflector_of(sample, library()), 60e9);
}

TEST_CASE("plates that waves come through are sheets; metal, backed ones and bodies are not",
          "[sim][object]") {
    const auto of = [](const std::string& material) {
        Sample sample;
        sample.material = material;
        return sample;
    };
    Sample sample = of("plexiglass");
    CHECK_FALSE(opaque(sample));
    sample.opaque = true;
    CHECK(opaque(sample));
    Sample backed = of("plexiglass");
    backed.backing = "metal";
    CHECK(opaque(backed));
    CHECK(opaque(of("aluminium")));
    CHECK(opaque(of("water")));  // 5 mm: some 100 dB
    Sample solid = of("plexiglass");
    solid.mesh = std::make_shared<const Mesh>(box_mesh({0.1, 0.1, 0.1}));
    CHECK(opaque(solid));
}

TEST_CASE("a metal plate in front leaves of the sample nothing to be seen", "[sim][object]") {
    Scene screened = scene_of("aluminium");
    screened.solver.max_bounces = 1;
    screened.objects = {plate_at(0.1, "aluminium", 0.25)};
    Scene screen_alone = scene_of("aluminium");
    screen_alone.sample.face = {.size_x_m = 0.25, .size_y_m = 0.25};
    screen_alone.pose.height_m -= 0.1;
    CHECK(std::abs(echo(screened) - echo(screen_alone)) < 1e-3 * std::abs(echo(screen_alone)));
}

TEST_CASE("a table seen through a sheet of foam echoes with the sheet's transmission, twice",
          "[sim][object]") {
    // Foam reflects so little, 2 %, that its own echo and rounds below it stay under 0.3 dB.
    Scene apart = scene_of("foam");
    apart.objects = {plate_at(-0.025, "aluminium", 0.2)};
    Scene bare = scene_of("aluminium");
    bare.pose.height_m += 0.025;
    const FrequencyComb comb = comb_of(apart.radar.chirp);
    const double f_hz = comb.at(comb.n / 2);
    const Transmission through =
        stack_transmission(reflector_of(apart.sample, library())(f_hz), 1.0);
    const Complex instead_of_air =
        through.te * std::polar(1.0, two_pi * f_hz / speed_of_light_m_s * apart.sample.thickness_m);
    const Deviation off = deviation(echo(apart), echo(bare) * instead_of_air * instead_of_air);
    CHECK(off.db < 0.3);
    CHECK(off.phase_deg < 3.0);
}

TEST_CASE("two plates in a corner send back what one alone sends away", "[sim][object]") {
    Scene plate = scene_of("aluminium");
    plate.pose.height_m = 0.6;
    plate.pose.sample.about_y_rad = 0.25 * 3.141592653589793;
    plate.pose.offset_x_m = -0.1;  // the edge on which the wall stands is the pivot
    Scene corner = plate;
    SceneObject wall = plate_at(0.1, "aluminium", 0.2);
    wall.own_placement.shift_m.x() = 0.1;
    wall.own_placement.rotation =
        Eigen::AngleAxisd(-0.5 * 3.141592653589793, Vector3::UnitY()).toRotationMatrix();
    wall.fixed_to_sample = true;
    corner.objects = {wall};
    CHECK(decibel(std::abs(echo(corner)) / std::abs(echo(plate))) > 20.0);
    // One bounce sees two plates that look away; the corner is in the second.
    Scene once = corner;
    once.solver.max_bounces = 1;
    CHECK(decibel(std::abs(echo(corner)) / std::abs(echo(once))) > 15.0);
}

TEST_CASE("a plate given as a mesh in a scene echoes like the plate", "[sim][mesh]") {
    const Scene plate = scene_of("plexiglass");
    Scene mesh = plate;
    mesh.sample.mesh = std::make_shared<const Mesh>(triangulate(plate.sample.face, {}));
    CHECK(deviation(echo(mesh), echo(plate)).db < 0.1);  // accuracy_db
}

}  // namespace
}  // namespace specula
