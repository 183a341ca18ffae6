#include "sim/trace/weighted_points.hpp"

#include "sim/trace/gauss_legendre.hpp"

namespace specula {

void append_points_on(const Surface& surface, const Patch& patch, PointCount count,
                      std::vector<WeightedPoint>& points) {
    const GaussRule& rule_u = gauss_legendre(count.u);
    const GaussRule& rule_v = gauss_legendre(count.v);
    for (std::size_t j = 0; j < rule_v.nodes.size(); ++j) {
        for (std::size_t i = 0; i < rule_u.nodes.size(); ++i) {
            const SurfacePoint at =
                surface_point(surface, patch.u_at(rule_u.nodes[i]), patch.v_at(rule_v.nodes[j]));
            const Vector3 normal = at.area_normal();
            const double stretch = normal.norm();
            points.push_back({at.point_m, normal / stretch,
                              stretch * patch.half_u() * patch.half_v() * rule_u.weights[i] *
                                  rule_v.weights[j]});
        }
    }
}

std::vector<WeightedPoint> points_on(const Surface& surface, const Patch& patch, PointCount count) {
    std::vector<WeightedPoint> points;
    points.reserve(static_cast<std::size_t>(count.u) * static_cast<std::size_t>(count.v));
    append_points_on(surface, patch, count, points);
    return points;
}

}  // namespace specula
