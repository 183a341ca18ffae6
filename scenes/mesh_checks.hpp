#pragma once

#include "scenes/mesh.hpp"

namespace specula {

/// How the triangles of a mesh hang together. Vertices count as the same by number.
struct Seams {
    std::size_t n_open = 0;    ///< edges of one triangle only
    std::size_t n_shared = 0;  ///< edges of three or more

    bool is_watertight() const { return n_open == 0 && n_shared == 0; }
};
Seams seams_of(const Mesh& mesh);

/// Drops triangles without area (thinner than 1e-9 of their length); returns how many.
std::size_t drop_degenerate(Mesh& mesh);

/// From a point to the nearest point of any triangle; infinite where there is none.
double distance_m(const Mesh& mesh, const Vector3& point_m);

/// Does a watertight mesh hold the point? Counts the triangles that a ray from it crosses.
bool encloses(const Mesh& mesh, const Vector3& point_m);

/// Opposite corners of the box around a mesh that has triangles.
struct Box {
    Vector3 low, high;
    Vector3 size() const { return high - low; }
};
Box box_around(const Mesh& mesh);

}  // namespace specula
