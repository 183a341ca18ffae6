#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <unordered_map>

#include "scenes/mesh.hpp"

namespace specula {

/// Gathers the vertices and polygons of a mesh file, in the file's own unit.
class MeshBuilder {
  public:
    /// The vertex's number in the file, from 0.
    void add_vertex(const Vector3& vertex) { vertices_.push_back(vertex); }
    std::size_t n_vertices() const { return vertices_.size(); }

    /// Corners by number, already in range. Four and more must lie in a plane and be convex; they
    /// become triangles about the first corner. Returns what is wrong, empty when nothing is.
    std::string add_polygon(std::span<const std::uint32_t> corners);

    /// Equal vertices become one. What it took is gone.
    Mesh take();

    static constexpr std::size_t most_triangles = 5'000'000;

  private:
    std::vector<Vector3> vertices_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace specula
