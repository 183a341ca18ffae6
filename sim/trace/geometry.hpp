#pragma once

#include <memory>
#include <span>
#include <vector>

#include "scenes/mesh.hpp"

namespace specula {

/// What rays can hit, in Embree's hands.
///
/// Embree answers in single precision, so it decides only whether something stands between two
/// points, never how far apart they are. Safe to ask from many threads at once.
class Geometry {
  public:
    /// Throws InputError when a vertex is not finite in single precision or an index is out of
    /// range.
    explicit Geometry(const std::vector<Mesh>& meshes);
    ~Geometry();
    Geometry(Geometry&&) noexcept;
    Geometry& operator=(Geometry&&) noexcept;

    /// Clears `clear[i]` where something lies between `from` and `to[i]`; leaves it as it is
    /// elsewhere. The last thousandth of each way is not looked at, since there `to[i]`'s own
    /// surface begins.
    void shadow(const Vector3& from, std::span<const Vector3> to, std::span<char> clear) const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

}  // namespace specula
