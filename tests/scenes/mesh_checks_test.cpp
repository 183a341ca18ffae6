#include "scenes/mesh_checks.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a box is watertight, holds its middle and nothing outside", "[mesh]") {
    const Mesh box = box_mesh({0.2, 0.4, 0.6});
    CHECK(seams_of(box).is_watertight());
    CHECK(encloses(box, {0.05, -0.1, -0.3}));
    for (const Vector3& outside :
         {Vector3(0.11, 0.0, -0.3), Vector3(0.0, 0.0, 0.01), Vector3(0.0, -0.21, -0.3)})
        CHECK_FALSE(encloses(box, outside));
    CHECK((box_around(box).size() - Vector3(0.2, 0.4, 0.6)).norm() < 1e-15);
    double volume = 0.0;  // of tetrahedra to the origin: positive only where all faces look out
    for (const auto& [a, b, c] : box.triangles)
        volume += box.vertices_m[a].dot(box.vertices_m[b].cross(box.vertices_m[c])) / 6.0;
    CHECK(volume == Approx(0.2 * 0.4 * 0.6));
}

TEST_CASE("the distance to a box is to its face, its edge or its corner", "[mesh]") {
    const Mesh box = box_mesh({2.0, 2.0, 2.0});
    CHECK(distance_m(box, {0.3, 0.2, 0.5}) == Approx(0.5));
    CHECK(distance_m(box, {4.0, 0.2, 4.0}) == Approx(5.0));
    CHECK(distance_m(box, {2.0, 3.0, 2.0}) == Approx(3.0));
}

TEST_CASE("a box without one triangle has three open seams", "[mesh]") {
    Mesh box = box_mesh({1.0, 1.0, 1.0});
    box.triangles.pop_back();
    CHECK(seams_of(box).n_open == 3);
}

}  // namespace
}  // namespace specula
