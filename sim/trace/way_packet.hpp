#pragma once

#include <span>

#include "sim/trace/geometry.hpp"

namespace specula {

/// Length at the ends of a way that is not looked at, since surfaces begin and end there.
inline constexpr double end_margin_m = 1e-4;

/// A way in metres from `origin` along a unit direction, cut to a sphere and freed of its ends.
struct Way {
    Vector3 origin;
    Vector3 direction;
    double near_m;
    double far_m;

    /// Debian's Embree ends the program on a ray that is not finite.
    bool is_traceable() const {
        return origin.allFinite() && direction.allFinite() && far_m > near_m;
    }
};
Way way_between(const Vector3& from, const Vector3& to, const BoundingSphere& around);

inline constexpr std::size_t packet_size = 16;

/// Ways from one point, as Embree takes them: arrays in single precision.
struct alignas(64) WayPacket {
    float origin_x[packet_size], origin_y[packet_size], origin_z[packet_size];
    float direction_x[packet_size], direction_y[packet_size], direction_z[packet_size];
    float near_m[packet_size], far_m[packet_size];
    int valid[packet_size];  ///< -1 where there is a way that Embree may follow, else 0
};

/// Where ways begin, in the scene's coordinates.
struct WaySource {
    const OwnFrame& frame;
    const BoundingSphere& around;  ///< in that frame
    const Vector3& from;
};

/// The same as way_between for up to `packet_size` ends, all at once.
void make_ways(const WaySource& source, std::span<const Vector3> to, WayPacket& packet);

}  // namespace specula
