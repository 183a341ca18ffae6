#include "sim/trace/surface.hpp"

namespace specula {

SurfacePoint PlateSurface::at(double u, double v) const {
    const double half_x = 0.5 * plate.size_x_m, half_y = 0.5 * plate.size_y_m;
    const double x = half_x * u, y = half_y * v;
    const Vector3 normal = plate.area_normal(x, y);
    return {placement.point({x, y, plate.height_m(x, y)}),
            half_x * placement.direction({1.0, 0.0, -normal.x()}),
            half_y * placement.direction({0.0, 1.0, -normal.y()})};
}

SurfacePoint TriangleSurface::at(double u, double v) const {
    const double s = 0.5 * (1.0 + u), t = 0.5 * (1.0 + v);
    const Vector3 side = c_m - b_m, to_side = b_m - a_m + t * side;
    return {a_m + s * to_side, 0.5 * to_side, 0.5 * s * side};
}

SurfacePoint surface_point(const Surface& surface, double u, double v) {
    return std::visit([&](const auto& s) { return s.at(u, v); }, surface);
}

}  // namespace specula
