#include "sim/channel/channel.hpp"
#include "sim/core/constants.hpp"
#include "sim/trace/trace.hpp"
#include "tests/check.hpp"
#include "tests/sim/deviation.hpp"
#include "tests/sim/plate_scene.hpp"

// However finely a body is cut into triangles, its echo is the same.

namespace specula {
namespace {

PlateScene tilted_plate() {
    PlateScene scene;
    scene.plate = {.size_x_m = 0.1, .size_y_m = 0.08};
    scene.pose.sample.about_y_rad = 0.05;
    return scene;
}

Complex echo(const Target& target, const AntennaSet& antennas) {
    const Reflector mirror = perfect_conductor();
    return direct_sum(trace(target, antennas, {.highest_hz = test_frequency_hz}), 0, {&mirror, 1},
                      test_frequency_hz);
}

/// The plate's face as n x n fields of two triangles.
Mesh gridded(const Plate& plate, const Placement& placement, std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i)
            mesh.vertices_m.push_back(
                placement.point({plate.size_x_m * (double(i) / n - 0.5),
                                 plate.size_y_m * (double(j) / n - 0.5), 0.0}));
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, c = a + n + 1;
            mesh.triangles.push_back({a, a + 1, c + 1});
            mesh.triangles.push_back({a, c + 1, c});
        }
    return mesh;
}

TEST_CASE("a plate echoes the same as 2, 200 or 20000 triangles", "[trace][mesh]") {
    const PlateScene scene = tilted_plate();
    const Complex exact = direct_sum(scene.scatter(test_frequency_hz), 0,
                                     std::array{perfect_conductor()}, test_frequency_hz);
    for (const std::uint32_t n : {1u, 10u, 100u}) {
        const Target target(
            {mesh_body(gridded(scene.plate, scene.plate_placement(), n), true, 0.0)});
        INFO(2 * n * n << " triangles");
        CHECK(deviation(echo(target, scene.antennas()), exact).db < 0.1);  // accuracy_db
    }
}

/// A sphere of 2n(n - 1) x 2 triangles, the poles on the z axis.
Mesh sphere(double radius_m, const Vector3& centre_m, std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t i = 0; i <= n; ++i)
        for (std::uint32_t j = 0; j < 2 * n; ++j) {
            const double theta = pi * i / n, phi = pi * j / n;
            mesh.vertices_m.push_back(centre_m + radius_m * Vector3(std::sin(theta) * std::cos(phi),
                                                                    std::sin(theta) * std::sin(phi),
                                                                    std::cos(theta)));
        }
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < 2 * n; ++j) {
            const std::uint32_t next = (j + 1) % (2 * n);
            const std::uint32_t a = i * 2 * n + j, d = i * 2 * n + next;
            const std::uint32_t b = a + 2 * n, c = d + 2 * n;
            if (i + 1 < n) mesh.triangles.push_back({a, b, c});
            if (i > 0) mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

TEST_CASE("a sphere echoes the same from 6000 and from 25000 triangles", "[trace][mesh]") {
    constexpr double radius_m = 0.02, range_m = 2.0;
    PlateScene scene;
    scene.pose.height_m = range_m;
    const auto echo_of = [&](std::uint32_t n) {
        return echo(Target({mesh_body(sphere(radius_m, Vector3::Zero(), n), true, 0.0)}),
                    scene.antennas());
    };
    const Complex coarse = echo_of(40), fine = echo_of(80);
    // The coarse one's triangles leave the sphere by 0.015 mm, 0.04 rad of phase.
    CHECK(deviation(coarse, fine).db < 0.1);
    // sigma = pi a^2; physical optics of a sphere of ka = 25 ripples by 0.2 dB about it.
    const double wavelength_m = speed_of_light_m_s / test_frequency_hz;
    const double nearest_m = range_m - radius_m;
    const double gain = gain_towards(scene.pattern, {0.0, 0.0, -1.0});
    const double expected =
        gain * wavelength_m * radius_m / (8.0 * pi * nearest_m * (nearest_m + radius_m));
    CHECK(decibel(std::abs(fine) / expected) == Approx(0.0).margin(0.3));
}

}  // namespace
}  // namespace specula
