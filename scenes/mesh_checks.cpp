#include "scenes/mesh_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace specula {

namespace {

struct Corners {
    const Vector3 &a, &b, &c;
};

Corners corners_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    return {mesh.vertices_m[triangle[0]], mesh.vertices_m[triangle[1]],
            mesh.vertices_m[triangle[2]]};
}

Vector3 nearest_on_edge(const Vector3& from, const Vector3& to, const Vector3& point) {
    const Vector3 along = to - from;
    const double share = along.dot(point - from) / along.squaredNorm();
    return from + std::clamp(share, 0.0, 1.0) * along;
}

double distance_to(const Corners& t, const Vector3& point) {
    const Vector3 ab = t.b - t.a, ac = t.c - t.a, ap = point - t.a;
    const Vector3 normal = ab.cross(ac);
    const double area = normal.squaredNorm();
    const double v = normal.dot(ap.cross(ac)) / area, w = normal.dot(ab.cross(ap)) / area;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return std::abs(normal.dot(ap)) / std::sqrt(area);
    return std::min({(nearest_on_edge(t.a, t.b, point) - point).norm(),
                     (nearest_on_edge(t.b, t.c, point) - point).norm(),
                     (nearest_on_edge(t.c, t.a, point) - point).norm()});
}

/// Moeller and Trumbore 1997.
bool is_crossed(const Corners& t, const Vector3& origin, const Vector3& direction) {
    const Vector3 ab = t.b - t.a, ac = t.c - t.a;
    const Vector3 p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0.0) return false;
    const Vector3 from_a = origin - t.a;
    const double u = from_a.dot(p) / determinant;
    const Vector3 q = from_a.cross(ab);
    const double v = direction.dot(q) / determinant;
    return u >= 0.0 && v >= 0.0 && u + v < 1.0 && ac.dot(q) / determinant > 0.0;
}

}  // namespace

Seams seams_of(const Mesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            edges.push_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    Seams seams;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::upper_bound(first, edges.end(), *first);
        if (last - first == 1) ++seams.n_open;
        if (last - first > 2) ++seams.n_shared;
        first = last;
    }
    return seams;
}

std::size_t drop_degenerate(Mesh& mesh) {
    return std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3>& triangle) {
        const Corners t = corners_of(mesh, triangle);
        const Vector3 ab = t.b - t.a, ac = t.c - t.a, bc = t.c - t.b;
        const double longest = std::max({ab.norm(), ac.norm(), bc.norm()});
        return !(ab.cross(ac).norm() > 1e-9 * longest * longest);
    });
}

double distance_m(const Mesh& mesh, const Vector3& point_m) {
    double least_m = std::numeric_limits<double>::infinity();
    for (const auto& triangle : mesh.triangles)
        least_m = std::min(least_m, distance_to(corners_of(mesh, triangle), point_m));
    return least_m;
}

bool encloses(const Mesh& mesh, const Vector3& point_m) {
    // No round numbers: a ray along an axis would meet edges of made-up meshes.
    const Vector3 direction = Vector3(0.3127, 0.5391, 0.7821).normalized();
    std::size_t n_crossed = 0;
    for (const auto& triangle : mesh.triangles)
        n_crossed += is_crossed(corners_of(mesh, triangle), point_m, direction);
    return n_crossed % 2 == 1;
}

Box box_around(const Mesh& mesh) {
    Box box{Vector3::Constant(std::numeric_limits<double>::infinity()), {}};
    box.high = -box.low;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) {
            box.low = box.low.cwiseMin(mesh.vertices_m[corner]);
            box.high = box.high.cwiseMax(mesh.vertices_m[corner]);
        }
    }
    return box;
}

}  // namespace specula
