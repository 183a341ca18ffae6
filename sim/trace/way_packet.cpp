#include "sim/trace/way_packet.hpp"

#include <cmath>

namespace specula {

Way way_between(const Vector3& from, const Vector3& to, const BoundingSphere& around) {
    const double length = (to - from).norm();
    Way way{from, (to - from) / length, end_margin_m, length - end_margin_m};
    const double outside = (from - around.centre_m).norm() - around.radius_m;
    if (outside > 0.0) {
        way.origin += outside * way.direction;
        way.near_m = 0.0;
        way.far_m -= outside;
    }
    return way;
}

void make_ways(const WaySource& source, std::span<const Vector3> to, WayPacket& packet) {
    const Vector3 begin = source.frame.point(source.from);
    const double outside =
        std::max(0.0, (begin - source.around.centre_m).norm() - source.around.radius_m);
    const double near_m = outside > 0.0 ? 0.0 : end_margin_m;
    const Rotation& turn = source.frame.to_own;
    const Vector3& origin = source.frame.origin_m;
    // Arrays apart, so that the compiler does several at a time.
    double x[packet_size] = {}, y[packet_size] = {}, z[packet_size] = {};
    for (std::size_t i = 0; i < to.size(); ++i) {
        x[i] = to[i].x() - origin.x();
        y[i] = to[i].y() - origin.y();
        z[i] = to[i].z() - origin.z();
    }
    for (std::size_t i = 0; i < packet_size; ++i) {
        const double dx = turn(0, 0) * x[i] + turn(0, 1) * y[i] + turn(0, 2) * z[i] - begin.x();
        const double dy = turn(1, 0) * x[i] + turn(1, 1) * y[i] + turn(1, 2) * z[i] - begin.y();
        const double dz = turn(2, 0) * x[i] + turn(2, 1) * y[i] + turn(2, 2) * z[i] - begin.z();
        const double length = std::sqrt(dx * dx + dy * dy + dz * dz);
        const double ux = dx / length, uy = dy / length, uz = dz / length;
        const double far_m = length - end_margin_m - outside;
        packet.origin_x[i] = static_cast<float>(begin.x() + outside * ux);
        packet.origin_y[i] = static_cast<float>(begin.y() + outside * uy);
        packet.origin_z[i] = static_cast<float>(begin.z() + outside * uz);
        packet.direction_x[i] = static_cast<float>(ux);
        packet.direction_y[i] = static_cast<float>(uy);
        packet.direction_z[i] = static_cast<float>(uz);
        packet.near_m[i] = static_cast<float>(near_m);
        packet.far_m[i] = static_cast<float>(far_m);
        // Not a number, or infinite, minus itself is not zero.
        const double sum = begin.x() + begin.y() + begin.z() + ux + uy + uz;
        packet.valid[i] = (far_m > near_m) & (sum - sum == 0.0) ? -1 : 0;
    }
    for (std::size_t i = to.size(); i < packet_size; ++i) packet.valid[i] = 0;
}

}  // namespace specula
