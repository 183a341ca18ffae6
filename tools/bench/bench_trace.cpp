#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace {

constexpr int tile = 4;  ///< points per side that go into one packet
constexpr int tiles_per_side = 64;
constexpr double widest_share = 0.9;  ///< of what is seen of the sphere: its rim is left out

/// Points of a rectangular or round face, tile by tile, so that the ways of a packet lie close.
template <typename At>
std::vector<Vector3> in_tiles(At at) {
    constexpr double per_side = tile * tiles_per_side;
    std::vector<Vector3> points;
    for (int row = 0; row < tiles_per_side; ++row)
        for (int column = 0; column < tiles_per_side; ++column)
            for (int i = 0; i < tile * tile; ++i)
                points.push_back(at(2.0 * (column * tile + i % tile + 0.5) / per_side - 1.0,
                                    2.0 * (row * tile + i / tile + 0.5) / per_side - 1.0));
    return points;
}

std::vector<Vector3> plate_points(double size_m) {
    return in_tiles(
        [&](double u, double v) { return Vector3(0.5 * size_m * u, 0.5 * size_m * v, 0.0); });
}

std::vector<Vector3> sphere_points(const BenchSphere& sphere) {
    // From `distance` a sphere is seen up to an angle of acos(radius / distance) off its top.
    const double widest_rad =
        widest_share * std::acos(sphere.radius_m / sphere.distance_m) / std::numbers::sqrt2;
    return in_tiles([&](double u, double v) {
        const double across = widest_rad * u, along = widest_rad * v;
        const Vector3 outward(std::sin(across), std::cos(across) * std::sin(along),
                              std::cos(across) * std::cos(along));
        return Vector3(sphere.radius_m * outward - Vector3(0.0, 0.0, sphere.distance_m));
    });
}

/// Rays to the same points: Embree alone, single and in packets, and ours with what it needs.
struct RayRace {
    const Geometry& geometry;
    const Vector3& from;
    const std::vector<Vector3>& to;
    std::string over;
};

void race(const BenchPlan& plan, const RayRace& rays, BenchReport& report) {
    const auto ready = rays.geometry.made_ready(rays.from, rays.to);
    const auto n = static_cast<double>(rays.to.size());
    const auto add = [&](const std::string& name, const std::string& limit,
                         const std::function<void()>& work) {
        report.add({.part = "trace",
                    .name = name + ", " + rays.over,
                    .unit = "rays",
                    .per_second = n / seconds_per_call(plan.budget_s, work),
                    .limit = limit.empty() ? "" : limit + ", " + rays.over});
    };
    add("Embree, single rays", "", [&] { rays.geometry.n_blocked(*ready, false); });
    add("Embree, packets of 16", "", [&] { rays.geometry.n_blocked(*ready, true); });
    std::vector<char> clear(rays.to.size(), 1);
    add("shadow rays", "Embree, packets of 16",
        [&] { rays.geometry.shadow(rays.from, rays.to, clear); });
}

}  // namespace

void bench_trace(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    const Scene plate = scene.plate("plexiglass", 0.0);
    const OpenScene open(plate, scene.catalogue.materials);
    const Vector3 radar_m = open.antennas.tx.position_m;
    race(plan,
         {open.target.geometry(), radar_m, plate_points(plate.sample.face.size_x_m), "2 triangles"},
         report);
    constexpr BenchSphere sphere{.n_around = 224};
    const Mesh mesh = sphere_mesh(sphere);
    const Geometry geometry({mesh});
    race(plan,
         {geometry, Vector3::Zero(), sphere_points(sphere),
          format("{} triangles", mesh.triangles.size())},
         report);
    constexpr double degree_rad = pi / 180.0;
    for (const int tilt_deg : {0, 15}) {
        const OpenScene tilted(scene.plate("plexiglass", tilt_deg * degree_rad),
                               scene.catalogue.materials);
        report.add({.part = "trace",
                    .name = format("plates traced, tilt {} deg", tilt_deg),
                    .unit = "geometries",
                    .per_second = 1.0 / seconds_per_call(plan.budget_s, [&] {
                                      trace(tilted.target, tilted.antennas, tilted.settings);
                                  })});
    }
}

}  // namespace specula
