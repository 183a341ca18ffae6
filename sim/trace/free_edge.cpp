#include "sim/trace/free_edge.hpp"

#include <array>
#include <cmath>
#include <map>

namespace specula {

namespace {

using Side = FreeEdge::Side;

/// Corners nearer than this are one corner, whatever the file numbers them.
constexpr double same_corner_m = 1e-7;

using CornerKey = std::array<long long, 3>;
using SideKey = std::array<CornerKey, 2>;

CornerKey key_of(const Vector3& corner_m) {
    CornerKey key;
    for (int axis = 0; axis < 3; ++axis)
        key[static_cast<std::size_t>(axis)] = std::llround(corner_m[axis] / same_corner_m);
    return key;
}

SideKey key_of(const Vector3& from_m, const Vector3& to_m) {
    SideKey key{key_of(from_m), key_of(to_m)};
    if (key[1] < key[0]) std::swap(key[0], key[1]);
    return key;
}

/// The sides of a triangle as its parameters u and v run along them.
std::array<std::pair<Side, SideKey>, 3> sides_of(const TriangleSurface& t) {
    return {{{Side::high_u, key_of(t.b_m, t.c_m)},
             {Side::low_v, key_of(t.a_m, t.b_m)},
             {Side::high_v, key_of(t.a_m, t.c_m)}}};
}

}  // namespace

FreeEdge::Place FreeEdge::at(double t) const {
    const bool runs_along_v = side == Side::low_u || side == Side::high_u;
    const double end = side == Side::low_u || side == Side::low_v ? -1.0 : 1.0;
    const SurfacePoint on =
        runs_along_v ? surface_point(surface, end, t) : surface_point(surface, t, end);
    const Vector3& along = runs_along_v ? on.along_v : on.along_u;
    const Vector3& across = runs_along_v ? on.along_u : on.along_v;
    const double stretch_m = along.norm();
    const Vector3 tangent = along / stretch_m;
    const Vector3 outward = end * (across - across.dot(tangent) * tangent);
    return {on.point_m, stretch_m, {-outward.normalized(), on.area_normal().normalized()}};
}

std::vector<FreeEdge> free_edges(const Body& body) {
    std::vector<FreeEdge> edges;
    std::map<SideKey, int> uses;
    for (const Surface& surface : body.surfaces)
        if (const auto* triangle = std::get_if<TriangleSurface>(&surface))
            for (const auto& [side, key] : sides_of(*triangle)) ++uses[key];
    for (const Surface& surface : body.surfaces) {
        if (const auto* triangle = std::get_if<TriangleSurface>(&surface)) {
            for (const auto& [side, key] : sides_of(*triangle))
                if (uses[key] == 1) edges.push_back({surface, side});
        } else if (std::holds_alternative<PlateSurface>(surface)) {
            for (const Side side : {Side::low_u, Side::high_u, Side::low_v, Side::high_v})
                edges.push_back({surface, side});
        }
    }
    return edges;
}

}  // namespace specula
