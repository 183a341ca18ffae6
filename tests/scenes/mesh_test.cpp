#include "scenes/mesh.hpp"

#include <cmath>
#include <map>

#include "tests/check.hpp"

namespace specula {
namespace {

Vector3 area_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const Vector3& a = mesh.vertices_m[triangle[0]];
    const Vector3 to_b = mesh.vertices_m[triangle[1]] - a, to_c = mesh.vertices_m[triangle[2]] - a;
    return 0.5 * to_b.cross(to_c);
}

TEST_CASE("a flat plate is two triangles of its area that face the radar", "[mesh]") {
    const Mesh mesh = triangulate({.size_x_m = 0.3, .size_y_m = 0.2}, {});
    REQUIRE(mesh.triangles.size() == 2);
    CHECK(mesh.vertices_m.size() == 4);
    for (const auto& triangle : mesh.triangles)
        CHECK((area_of(mesh, triangle) - Vector3(0.0, 0.0, 0.03)).norm() < 1e-17);
}

TEST_CASE("a placed plate is the same plate elsewhere", "[mesh]") {
    const Placement placement =
        sample_placement({.sample = {.about_x_rad = 0.1, .about_y_rad = 0.5}, .offset_x_m = 0.02});
    const Plate plate{.size_x_m = 0.3, .size_y_m = 0.2, .bow_m = 5e-3};
    const Mesh here = triangulate(plate, {}), there = triangulate(plate, placement);
    REQUIRE(here.vertices_m.size() == there.vertices_m.size());
    CHECK(here.triangles == there.triangles);
    double worst_m = 0.0;
    for (std::size_t i = 0; i < here.vertices_m.size(); ++i)
        worst_m = std::max(
            worst_m, (placement.point(here.vertices_m[i]) - there.vertices_m[i]).norm());
    CHECK(worst_m == 0.0);
}

TEST_CASE("a bowed mesh has no gap: its inner edges are shared, its outer ones are the rim",
          "[mesh]") {
    const Plate plate{.size_x_m = 0.3, .size_y_m = 0.2, .bow_m = 5e-3};
    const Mesh mesh = triangulate(plate, {});
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
    double rim_m = 0.0;
    bool shared_once = true;
    for (const auto& [edge, n] : directed) {
        shared_once = shared_once && n == 1;
        if (directed.count({edge.second, edge.first})) continue;
        const Vector3 along = mesh.vertices_m[edge.second] - mesh.vertices_m[edge.first];
        rim_m += std::hypot(along.x(), along.y());
    }
    CHECK(shared_once);
    CHECK(rim_m == Approx(2.0 * (0.3 + 0.2)).epsilon(1e-12));
    // So the vector areas add up to what the rim encloses, its average height apart.
    Vector3 sum = Vector3::Zero();
    for (const auto& triangle : mesh.triangles) {
        sum += area_of(mesh, triangle);
        CHECK(area_of(mesh, triangle).z() > 0.0);
    }
    CHECK((sum - Vector3(0.0, 0.0, 0.06)).norm() < 1e-14);
}

TEST_CASE("a bowed mesh has the area of the paraboloid", "[mesh]") {
    const Plate plate{.size_x_m = 0.3, .size_y_m = 0.3, .bow_m = 2e-2};
    const Mesh mesh = triangulate(plate, {});
    double area_m2 = 0.0;
    for (const auto& triangle : mesh.triangles) area_m2 += area_of(mesh, triangle).norm();
    double expected_m2 = 0.0;  // midpoint rule, error of the order 1 / n^2
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            expected_m2 +=
                plate.area_normal(0.3 * ((i + 0.5) / n - 0.5), 0.3 * ((j + 0.5) / n - 0.5)).norm() *
                0.09 / (n * n);
    CHECK(area_m2 < expected_m2);  // chords are shorter than arcs
    CHECK(area_m2 == Approx(expected_m2).epsilon(2e-5));
}

TEST_CASE("no triangle of a bowed mesh leaves the surface by more than 1/2048 of the bow",
          "[mesh]") {
    for (const double bow_m : {5e-2, -1e-3}) {
        const Plate plate{.size_x_m = 0.3, .size_y_m = 0.2, .bow_m = bow_m};
        const Mesh mesh = triangulate(plate, {});
        double worst_m = 0.0;
        for (const auto& t : mesh.triangles)
            for (const auto& [u, v] : {std::pair{0.5, 0.5}, {0.5, 0.0}, {0.0, 0.5}, {0.3, 0.3},
                                       {0.0, 0.0}}) {
                const Vector3 p = (1.0 - u - v) * mesh.vertices_m[t[0]] + u * mesh.vertices_m[t[1]] +
                                  v * mesh.vertices_m[t[2]];
                worst_m = std::max(worst_m, std::abs(p.z() - plate.height_m(p.x(), p.y())));
            }
        CHECK(worst_m <= std::abs(bow_m) / 2048.0 * (1.0 + 1e-9));
        CHECK(worst_m > std::abs(bow_m) / 4096.0);  // the middle of a diagonal is that far off
    }
}

}  // namespace
}  // namespace specula
