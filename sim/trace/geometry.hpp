#pragma once

#include <memory>
#include <span>
#include <vector>

#include "scenes/mesh.hpp"

namespace specula {

/// A sphere around everything that rays can hit.
struct BoundingSphere {
    Vector3 centre_m = Vector3::Zero();
    double radius_m = 0.0;
};

/// The frame of what rays can hit: about its middle, along its first triangle. Moved with its
/// antennas, a scene looks the same in it, so that Embree's rounding does not depend on where the
/// scene stands and how it is turned.
struct OwnFrame {
    Vector3 origin_m = Vector3::Zero();
    Rotation to_own = Rotation::Identity();

    Vector3 point(const Vector3& p_m) const { return to_own * (p_m - origin_m); }
    Vector3 direction(const Vector3& d) const { return to_own * d; }
};

/// What rays can hit, in Embree's hands.
///
/// Embree answers in single precision, so it decides only what stands between two points, never
/// how far apart they are. It works in a frame of the scene's own, so that moving or turning the
/// whole scene changes nothing, and rays are cut to the sphere around the scene, so that far
/// antennas cost no precision. Safe to ask from many threads at once.
class Geometry {
  public:
    /// Mesh i is geometry i. Throws InputError when a vertex is not finite in single precision or
    /// an index is out of range.
    explicit Geometry(const std::vector<Mesh>& meshes);
    ~Geometry();
    Geometry(Geometry&&) noexcept;
    Geometry& operator=(Geometry&&) noexcept;

    /// Clears `clear[i]` where something lies between `from` and `to[i]`; leaves it as it is
    /// elsewhere. The surfaces at the two ends do not count.
    void shadow(const Vector3& from, std::span<const Vector3> to, std::span<char> clear) const;

    /// The geometries crossed on the way, in order; those at the two ends do not count. At most
    /// `most_crossings`, the rest left out.
    std::vector<int> crossings(const Vector3& from, const Vector3& to) const;

    /// Does the geometry of that number hold the point, seen along a direction through it?
    bool holds(int geometry, const Vector3& point, const Vector3& direction) const;

    static constexpr int most_crossings = 16;

    /// The same question made ready for Embree, to measure what Embree alone can do.
    struct ReadyRays;
    std::shared_ptr<ReadyRays> made_ready(const Vector3& from, std::span<const Vector3> to) const;
    /// How many of the ways something lies on; asked sixteen at a time, or each alone.
    std::size_t n_blocked(const ReadyRays& rays, bool in_packets) const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

}  // namespace specula
