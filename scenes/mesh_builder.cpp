#include "scenes/mesh_builder.hpp"

#include <bit>
#include <cmath>

#include "sim/core/format.hpp"

namespace specula {

namespace {

/// How far a polygon's corner may leave its plane, in shares of the polygon's size.
constexpr double flat_enough = 1e-3;

struct VertexHash {
    std::size_t operator()(const Vector3& v) const {
        std::size_t hash = 14695981039346656037ull;  // FNV-1a
        for (int axis = 0; axis < 3; ++axis) {
            const double value = v[axis] == 0.0 ? 0.0 : v[axis];  // -0 equals 0
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ull;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

}  // namespace

std::string MeshBuilder::add_polygon(std::span<const std::uint32_t> corners) {
    if (corners.size() < 3) return format("a face of {} corners", corners.size());
    if (triangles_.size() + corners.size() - 2 > most_triangles)
        return format("more than {} triangles", most_triangles);
    if (corners.size() > 3) {
        Vector3 area = Vector3::Zero();  // Newell's: exact for any flat polygon
        double size = 0.0;
        const Vector3& first = vertices_[corners[0]];
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            area += (vertices_[corners[i]] - first).cross(vertices_[corners[i + 1]] - first);
        for (const std::uint32_t corner : corners)
            size = std::max(size, (vertices_[corner] - first).norm());
        const Vector3 normal = area.normalized();
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const Vector3 along = vertices_[corners[i]] - first;
            const Vector3 next = vertices_[corners[i + 1]] - first;
            if (std::abs(normal.dot(along)) > flat_enough * size ||
                std::abs(normal.dot(next)) > flat_enough * size ||
                normal.dot(along.cross(next)) < -1e-9 * size * size)
                return format("a face of {} corners is not flat and convex", corners.size());
        }
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        triangles_.push_back({corners[0], corners[i], corners[i + 1]});
    return "";
}

Mesh MeshBuilder::take() {
    Mesh mesh;
    std::unordered_map<Vector3, std::uint32_t, VertexHash> number_of;
    std::vector<std::uint32_t> welded;
    welded.reserve(vertices_.size());
    for (const Vector3& vertex : vertices_) {
        const auto [found, fresh] =
            number_of.try_emplace(vertex, static_cast<std::uint32_t>(mesh.vertices_m.size()));
        if (fresh) mesh.vertices_m.push_back(vertex);
        welded.push_back(found->second);
    }
    for (const auto& [a, b, c] : triangles_)
        mesh.triangles.push_back({welded[a], welded[b], welded[c]});
    vertices_.clear();
    triangles_.clear();
    return mesh;
}

}  // namespace specula
