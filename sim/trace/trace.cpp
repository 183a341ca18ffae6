#include "sim/trace/trace.hpp"

#include <algorithm>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"
#include "sim/trace/patch.hpp"
#include "sim/trace/physical_optics.hpp"

namespace specula {

namespace {

/// A patch whose visibility changes within it is halved until it is this small.
constexpr double smallest_cut_m = 1e-3;

struct SurfacePoint {
    Vector3 normal;  ///< unit
    double area_m2;
};

/// The points of a patch, and which of them both antennas see.
struct PatchPoints {
    std::vector<Vector3> points_m;
    std::vector<SurfacePoint> surface;
    std::vector<char> clear;
};

PatchPoints place_points(const PlateView& view, const Patch& patch, PointCount count) {
    const GaussRule& rule_x = gauss_legendre(count.x);
    const GaussRule& rule_y = gauss_legendre(count.y);
    const double quarter_area =
        0.25 * (patch.x_m[1] - patch.x_m[0]) * (patch.y_m[1] - patch.y_m[0]);
    PatchPoints placed;
    placed.points_m.reserve(rule_x.nodes.size() * rule_y.nodes.size());
    placed.surface.reserve(placed.points_m.capacity());
    for (std::size_t j = 0; j < rule_y.nodes.size(); ++j) {
        for (std::size_t i = 0; i < rule_x.nodes.size(); ++i) {
            const double x_m = patch.x_at(rule_x.nodes[i]), y_m = patch.y_at(rule_y.nodes[j]);
            const Vector3 normal = view.plate.area_normal(x_m, y_m);
            const double stretch = normal.norm();
            placed.points_m.push_back(
                view.plate_placement.point({x_m, y_m, view.plate.height_m(x_m, y_m)}));
            placed.surface.push_back(
                {view.plate_placement.direction(normal / stretch),
                 quarter_area * rule_x.weights[i] * rule_y.weights[j] * stretch});
        }
    }
    return placed;
}

void find_clear(const Geometry& geometry, const AntennaPair& pair, PatchPoints& placed) {
    placed.clear.assign(placed.points_m.size(), 1);
    for (std::size_t i = 0; i < placed.points_m.size(); ++i) {
        const Vector3& n = placed.surface[i].normal;
        const bool lit = n.dot(pair.tx_m - placed.points_m[i]) > 0.0;
        const bool seen = n.dot(pair.rx_m - placed.points_m[i]) > 0.0;
        placed.clear[i] = lit && seen;
    }
    geometry.shadow(pair.tx_m, placed.points_m, placed.clear);
    geometry.shadow(pair.rx_m, placed.points_m, placed.clear);
}

/// Cuts a patch in two across its longer side, or across the axis that needs more points.
std::pair<Patch, Patch> halves(const Patch& patch, bool across_x) {
    Patch first = patch, second = patch;
    if (across_x)
        first.x_m[1] = second.x_m[0] = patch.x_at(0.0);
    else
        first.y_m[1] = second.y_m[0] = patch.y_at(0.0);
    return {first, second};
}

class PairTracer {
  public:
    PairTracer(const PlateView& view, const Radar& radar, const Geometry& geometry,
               const AntennaPair& pair, double wavelength_m)
        : view_(view),
          radar_(radar),
          geometry_(geometry),
          pair_(pair),
          wavelength_m_(wavelength_m) {}

    void add(const Patch& patch) {
        const PointCount count = points_needed(view_, pair_, patch, wavelength_m_);
        if (count.x > largest_gauss_rule || count.y > largest_gauss_rule)
            return add_halves(patch, count.x > count.y);
        PatchPoints placed = place_points(view_, patch, count);
        find_clear(geometry_, pair_, placed);
        const auto n_clear = std::count(placed.clear.begin(), placed.clear.end(), 1);
        const bool partly = n_clear > 0 && n_clear < static_cast<long>(placed.clear.size());
        const double size_x = patch.x_m[1] - patch.x_m[0], size_y = patch.y_m[1] - patch.y_m[0];
        if (partly && std::max(size_x, size_y) > smallest_cut_m)
            return add_halves(patch, size_x > size_y);
        for (std::size_t i = 0; i < placed.clear.size(); ++i)
            if (placed.clear[i]) add_point(placed.points_m[i], placed.surface[i]);
    }

    PairScatter take() { return std::move(scatter_); }

  private:
    void add_halves(const Patch& patch, bool across_x) {
        const auto [first, second] = halves(patch, across_x);
        add(first);
        add(second);
    }

    void add_point(const Vector3& point, const SurfacePoint& surface) {
        const Vector3 from_tx = point - pair_.tx_m, to_rx = pair_.rx_m - point;
        const double r1 = from_tx.norm(), r2 = to_rx.norm();
        const Rotation& radar = view_.radar_placement.rotation;
        Bounce bounce;
        bounce.to_point = from_tx / r1;
        bounce.to_rx = to_rx / r2;
        bounce.normal = surface.normal;
        bounce.tx_field =
            radar * field_pattern(radar_.pattern, radar.transpose() * bounce.to_point);
        bounce.rx_field = radar * field_pattern(radar_.pattern, radar.transpose() * -bounce.to_rx);
        const BounceWeights weights = bounce_weights(bounce);
        const double spread = surface.area_m2 / (r1 * r2);
        scatter_.path_m.push_back(r1 + r2);
        scatter_.cos_incidence.push_back(std::min(1.0, -bounce.to_point.dot(surface.normal)));
        scatter_.incident.push_back(weights.incident * spread);
        scatter_.te.push_back(weights.te * spread);
        scatter_.tm.push_back(weights.tm * spread);
    }

    const PlateView& view_;
    const Radar& radar_;
    const Geometry& geometry_;
    AntennaPair pair_;
    double wavelength_m_;
    PairScatter scatter_;
};

}  // namespace

Scatter trace(const PlateView& view, const Radar& radar, const Geometry& geometry,
              double highest_hz) {
    const double half_x_m = 0.5 * view.plate.size_x_m, half_y_m = 0.5 * view.plate.size_y_m;
    const Patch whole{{-half_x_m, half_x_m}, {-half_y_m, half_y_m}};
    Scatter scatter;
    for (const ReceiveChannel& channel : radar.rx) {
        const AntennaPair pair{view.radar_placement.point(radar.tx_position_m),
                               view.radar_placement.point(channel.position_m)};
        PairTracer tracer(view, radar, geometry, pair, speed_of_light_m_s / highest_hz);
        tracer.add(whole);
        scatter.rx.push_back(tracer.take());
    }
    return scatter;
}

}  // namespace specula
