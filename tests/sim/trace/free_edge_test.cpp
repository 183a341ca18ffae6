#include "sim/trace/free_edge.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

double length_m(const std::vector<FreeEdge>& edges) {
    double sum = 0.0;
    for (const FreeEdge& edge : edges) sum += 2.0 * edge.at(0.0).stretch_m;  // straight ones
    return sum;
}

Mesh box() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices_m.push_back({i & 1 ? 0.1 : 0.0, i & 2 ? 0.1 : 0.0, i & 4 ? 0.1 : 0.0});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TEST_CASE("a plate has a rim of four edges, inside pointing in", "[edges]") {
    const Plate plate{.size_x_m = 0.2, .size_y_m = 0.1};
    const auto edges = free_edges(plate_body(plate, {}, true, 0.0));
    REQUIRE(edges.size() == 4);
    CHECK(length_m(edges) == Approx(0.6));
    for (const FreeEdge& edge : edges) {
        const FreeEdge::Place place = edge.at(0.3);
        CHECK(place.frame.inward.dot(-place.point_m) > 0.0);
        CHECK(place.frame.normal.z() == Approx(1.0));
        CHECK(std::abs(place.frame.inward.dot(place.frame.normal)) < 1e-15);
    }
}

TEST_CASE("where triangles meet there is no free edge", "[edges]") {
    const Plate plate{.size_x_m = 0.2, .size_y_m = 0.1};
    const auto edges = free_edges(mesh_body(triangulate(plate, {}), true, 0.0));
    CHECK(edges.size() == 4);
    CHECK(length_m(edges) == Approx(0.6));
    for (const FreeEdge& edge : edges)
        CHECK(edge.at(0.3).frame.inward.dot(-edge.at(0.3).point_m) > 0.0);
    CHECK(free_edges(mesh_body(box(), true, 0.0)).empty());
}

TEST_CASE("corners that a file lists twice are one corner", "[edges]") {
    Mesh soup;
    const Mesh closed = box();
    for (const auto& triangle : closed.triangles) {
        const auto first = static_cast<std::uint32_t>(soup.vertices_m.size());
        for (const std::uint32_t corner : triangle)
            soup.vertices_m.push_back(closed.vertices_m[corner]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    CHECK(free_edges(mesh_body(soup, true, 0.0)).empty());
    soup.triangles.pop_back();
    CHECK(free_edges(mesh_body(soup, true, 0.0)).size() == 3);
}

TEST_CASE("the rim of a bowed plate runs along its true surface", "[edges]") {
    const Plate plate{.size_x_m = 0.2, .size_y_m = 0.2, .bow_m = 0.01};
    for (const FreeEdge& edge : free_edges(plate_body(plate, {}, true, 0.0))) {
        CHECK(edge.at(0.0).point_m.z() == Approx(-0.01));
        CHECK(edge.at(0.999999).point_m.z() == Approx(-0.02).epsilon(1e-4));
        CHECK(edge.at(0.0).frame.inward.z() > 0.05);  // up towards the middle
    }
}

}  // namespace
}  // namespace specula
