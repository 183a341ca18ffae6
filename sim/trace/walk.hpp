#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/trace/scatter.hpp"
#include "sim/trace/target.hpp"

namespace specula {

/// Flat faces that mirror the wave on its way, in its order, and the images of the TX: `images[i]`
/// is the TX mirrored in the first i of them.
struct Mirrors {
    std::vector<int> faces;
    std::vector<Vector3> images;

    const Vector3& source() const { return images.back(); }
    Mirrors with(int face, const Target& target) const;
};

Mirrors no_mirrors(const Vector3& tx_m);

/// An event and the wave at it.
struct EventAt {
    Event event;
    Vector3 direction;  ///< unit, of the wave that arrives
    Vector3 normal;     ///< unit
};

/// The way of a wave over one surface point.
struct Walk {
    std::uint64_t signature = 0;  ///< equal for points whose ways meet the same faces
    std::vector<EventAt> before;
    std::vector<EventAt> after;
    Vector3 leaving;           ///< unit, from the TX
    Vector3 arriving;          ///< unit, at the point
    Vector3 normal;            ///< unit, of the point's surface, against the wave
    bool from_behind = false;  ///< of a sheet; an opaque body is the same on both sides
};

struct PointOnFace {
    Vector3 point_m;
    Vector3 normal;  ///< unit, front side
    int face = 0;
};

/// Follows the wave from the TX over the mirrors to a point and on to the RX. Nothing when an
/// opaque body is in the way, a mirror is missed, or the point's surface faces away from one of
/// them.
std::optional<Walk> walk(const Target& target, const Mirrors& mirrors, const PointOnFace& on,
                         const Vector3& rx_m);

}  // namespace specula
