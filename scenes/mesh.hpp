#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scenes/plate.hpp"
#include "scenes/pose.hpp"

namespace specula {

/// Triangles in the scene's frame; what rays can hit.
struct Mesh {
    std::vector<Vector3> vertices_m;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The face of a plate in its place. A flat one is two triangles; a bowed one is cut so finely
/// that no triangle leaves the surface by more than 1/2048 of the bow.
Mesh triangulate(const Plate& plate, const Placement& placement);

/// A box below the plane z = 0: the centre of its upper face is the origin; 12 triangles that face
/// outwards.
Mesh box_mesh(const Vector3& size_m);

Mesh placed(Mesh mesh, const Placement& placement);

}  // namespace specula
