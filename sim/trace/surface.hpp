#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "scenes/mesh.hpp"

namespace specula {

/// A point of a surface with what an integral over the surface needs there.
struct SurfacePoint {
    Vector3 point_m;
    Vector3 along_u;  ///< derivative of the point by u, m
    Vector3 along_v;  ///< derivative of the point by v, m

    Vector3 area_normal() const { return along_u.cross(along_v); }
};

/// The face of a plate, u and v in [-1, 1] over its x and y.
struct PlateSurface {
    Plate plate;
    Placement placement;
    SurfacePoint at(double u, double v) const;
};

/// A flat triangle; u in [-1, 1] runs from corner a to the opposite side, v in [-1, 1] along it.
struct TriangleSurface {
    Vector3 a_m, b_m, c_m;
    SurfacePoint at(double u, double v) const;
};

/// A flat disc about the origin of its own frame, normal +z: u is the radius, v the angle.
struct DiscSurface {
    double radius_m;
    Placement placement;
    SurfacePoint at(double u, double v) const;
};

/// The side of a round cylinder about the z axis of its own frame: u is the angle, v runs along.
struct CylinderSurface {
    double radius_m;
    double length_m;
    Placement placement;
    SurfacePoint at(double u, double v) const;
};

/// A sphere about the origin of its own frame: u is the angle from the pole +z, v the azimuth.
struct SphereSurface {
    double radius_m;
    Placement placement;
    SurfacePoint at(double u, double v) const;
};

/// A smooth piece of surface over u, v in [-1, 1].
using Surface =
    std::variant<PlateSurface, TriangleSurface, DiscSurface, CylinderSurface, SphereSurface>;

SurfacePoint surface_point(const Surface& surface, double u, double v);

/// The surface in triangles with their corners on it.
struct Cells {
    std::uint32_t along_u;
    std::uint32_t along_v;
};
Mesh triangulate(const Surface& surface, const Cells& cells);

/// A rectangle of a surface's parameters.
struct Patch {
    double u[2] = {-1.0, 1.0};
    double v[2] = {-1.0, 1.0};

    double u_at(double s) const { return 0.5 * ((u[1] - u[0]) * s + u[0] + u[1]); }
    double v_at(double t) const { return 0.5 * ((v[1] - v[0]) * t + v[0] + v[1]); }
    double half_u() const { return 0.5 * (u[1] - u[0]); }
    double half_v() const { return 0.5 * (v[1] - v[0]); }
};

/// A surface cut so that points at even steps of u and v bend the phase little more than
/// quadratically: round ones into eighths of a turn.
std::vector<Patch> patches_of(const Surface& surface);

}  // namespace specula
