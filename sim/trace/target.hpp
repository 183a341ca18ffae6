#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "sim/trace/geometry.hpp"
#include "sim/trace/surface.hpp"

namespace specula {

/// An object as waves meet it: its faces, and whether they come through.
struct Body {
    std::vector<Surface> surfaces;
    Mesh mesh;           ///< the same in triangles; of a plate, made when rays need it
    bool opaque = true;  ///< nothing passes; else a sheet of `thickness_m` that is all front face
    double thickness_m = 0.0;
};

Body plate_body(const Plate& plate, const Placement& placement, bool opaque, double thickness_m);

/// An opaque body of one smooth surface. The triangles that rays meet lie inside a convex one, so
/// it casts no shadow on its own lit side.
Body smooth_body(const Surface& surface);

/// Triangles in the scene's frame. Throws InputError for vertices that are not finite and indices
/// out of range; triangles without area are left out.
Body mesh_body(const Mesh& mesh, bool opaque, double thickness_m);

/// A smooth part of a body. Waves are followed from face to face over flat ones only.
struct Face {
    int body = 0;
    std::vector<Surface> surfaces;
    bool flat = false;
    Vector3 point_m = Vector3::Zero();  ///< of the plane of a flat face or of a plate's centre
    Vector3 normal = Vector3::UnitZ();  ///< unit
};

/// Everything a radar may look at, ready for rays.
class Target {
  public:
    explicit Target(std::vector<Body> bodies);

    const std::vector<Body>& bodies() const { return bodies_; }
    const std::vector<Face>& faces() const { return faces_; }
    const Body& body_of(int face) const { return bodies_[faces_[face].body]; }
    /// Geometry number i is face number i. Made for the first who asks, from whichever thread.
    const Geometry& geometry() const;
    /// A plate by itself, flat or bowed; else nullptr.
    const PlateSurface* lone_plate() const;

    /// A body of more flat parts than this is one curved face.
    static constexpr int most_flat_faces = 48;

  private:
    std::vector<Body> bodies_;
    std::vector<Face> faces_;
    struct Rays {
        std::once_flag once;
        std::unique_ptr<Geometry> geometry;
    };
    std::unique_ptr<Rays> rays_ = std::make_unique<Rays>();
};

}  // namespace specula
