#include "sim/trace/thin_plate.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"
#include "sim/trace/thin_nodes.hpp"

namespace specula {

namespace {

/// Few points pay where they are fewer than this share of many.
constexpr double worth_while = 0.4;

/// Height of a point over the plate's surface continued beyond its rim, in the plate's frame.
double height_over(const PlateSurface& plate, const Vector3& point_m) {
    const Vector3 own = plate.placement.rotation.transpose() * (point_m - plate.placement.shift_m);
    return own.z() - plate.plate.height_m(own.x(), own.y());
}

/// Is the antenna's pattern a smooth function over the plate? Tables have kinks, and a patch's
/// gain ends where its front does.
bool is_smooth_over(const PlateSurface& plate, const PlacedAntenna& antenna) {
    constexpr double least_forward = 0.2;
    if (std::holds_alternative<IsotropicPattern>(antenna.pattern)) return true;
    if (!std::holds_alternative<PatchPattern>(antenna.pattern)) return false;
    for (const double u : {-1.0, 1.0})
        for (const double v : {-1.0, 1.0}) {
            const Vector3 towards = (plate.at(u, v).point_m - antenna.position_m).normalized();
            if (-(antenna.rotation.transpose() * towards).z() < least_forward) return false;
        }
    return true;
}

class ThinPlate {
  public:
    ThinPlate(const Target& target, const AntennaSet& antennas, const TraceSettings& settings)
        : surface_(target.faces()[0].surfaces[0]),
          antennas_(antennas),
          settings_(settings),
          is_opaque_(target.bodies()[0].opaque),
          detail_(detail_of(settings)) {
        route_.rx.resize(antennas.rx.size());
        for (PairScatter& pair : route_.rx) pair.weight.resize(route_.route.n_weights());
    }

    /// False where few points are not worth while.
    bool add(const Patch& patch) {
        ThinPoints::Counts counts{{1, 1}, {1, 1}};
        for (const PlacedAntenna& rx : antennas_.rx) {
            const PhaseCentres centres{antennas_.tx.position_m, rx.position_m};
            const PointCount dense =
                points_needed(surface_, patch, centres, speed_of_light_m_s / settings_.highest_hz,
                              settings_.accuracy_db);
            const PointCount thin =
                thin_points_needed(surface_, patch, centres, detail_, settings_.accuracy_db);
            counts.dense = {std::max(counts.dense.u, dense.u), std::max(counts.dense.v, dense.v)};
            counts.thin = {std::max(counts.thin.u, thin.u), std::max(counts.thin.v, thin.v)};
        }
        const PointCount& dense = counts.dense;
        if (dense.u > largest_gauss_rule || dense.v > largest_gauss_rule)
            return add_halves(patch, dense.u > dense.v);
        if (counts.thin.u * counts.thin.v > worth_while * dense.u * dense.v) return false;
        const ThinPoints points = ThinPoints::of_patch(surface_, patch, counts);
        const std::vector<LitNode> lit = lit_nodes(surface_, points, antennas_.tx);
        route_.route.from_behind = lit.front().at_back && !is_opaque_;
        for (std::size_t rx = 0; rx < antennas_.rx.size(); ++rx) add_pair(points, lit, rx);
        return true;
    }

    Scatter take() {
        return {.n_rx = static_cast<int>(antennas_.rx.size()), .routes = {std::move(route_)}};
    }

  private:
    bool add_halves(const Patch& patch, bool across_u) {
        Patch first = patch, second = patch;
        if (across_u)
            first.u[1] = second.u[0] = patch.u_at(0.0);
        else
            first.v[1] = second.v[0] = patch.v_at(0.0);
        return add(first) && add(second);
    }

    void add_pair(const ThinPoints& points, const std::vector<LitNode>& lit, std::size_t rx) {
        const PlacedAntenna& receiver = antennas_.rx[rx];
        const auto sums =
            points.weights({antennas_.tx.position_m, receiver.position_m}, detail_.centre_rad_m);
        const NodeViewer seen_from(receiver);
        for (std::size_t i = 0; i < lit.size(); ++i) {
            const NodeView view = seen_from(lit[i]);
            append(lit[i], view,
                   {.sum = sums[i],
                    .spread = lit[i].stretch_m2 / (lit[i].r1_m * view.r2_m),
                    .cos_incidence = -lit[i].arriving.dot(lit[i].normal),
                    .centre_rad_m = detail_.centre_rad_m},
                   route_.rx[rx]);
        }
    }

    const Surface& surface_;
    const AntennaSet& antennas_;
    const TraceSettings& settings_;
    bool is_opaque_;
    Detail detail_;
    RouteScatter route_;
};

}  // namespace

bool is_seen_whole(const PlateSurface& plate, const AntennaSet& antennas) {
    std::vector<Vector3> places{antennas.tx.position_m};
    for (const PlacedAntenna& rx : antennas.rx) places.push_back(rx.position_m);
    const bool above = height_over(plate, places.front()) > 0.0;
    // Over a paraboloid, the angle to its normal is least favourable at a corner.
    for (const Vector3& place : places) {
        if ((height_over(plate, place) > 0.0) != above) return false;
        for (const double u : {-1.0, 1.0})
            for (const double v : {-1.0, 1.0}) {
                const SurfacePoint corner = plate.at(u, v);
                const double front = corner.area_normal().dot(place - corner.point_m);
                if (front == 0.0 || (front > 0.0) != above) return false;
            }
    }
    return true;
}

const PlateSurface* thinnable_plate(const Target& target, const AntennaSet& antennas,
                                    const TraceSettings& settings) {
    const PlateSurface* plate = target.lone_plate();
    const bool has_band = settings.lowest_hz > 0.0 && settings.lowest_hz < settings.highest_hz;
    if (!plate || !has_band || !is_seen_whole(*plate, antennas)) return nullptr;
    if (!is_smooth_over(*plate, antennas.tx)) return nullptr;
    for (const PlacedAntenna& rx : antennas.rx)
        if (!is_smooth_over(*plate, rx)) return nullptr;
    return plate;
}

Detail detail_of(const TraceSettings& settings) {
    const double low = two_pi * settings.lowest_hz / speed_of_light_m_s;
    const double high = two_pi * settings.highest_hz / speed_of_light_m_s;
    return {.centre_rad_m = 0.5 * (low + high),
            .half_band_rad_m = 0.5 * (high - low),
            .layer_path_m = settings.layer_path_m};
}

std::optional<Scatter> trace_thin_plate(const Target& target, const AntennaSet& antennas,
                                        const TraceSettings& settings) {
    if (!thinnable_plate(target, antennas, settings)) return std::nullopt;
    ThinPlate thin(target, antennas, settings);
    for (const Patch& patch : patches_of(target.faces()[0].surfaces[0]))
        if (!thin.add(patch)) return std::nullopt;
    return thin.take();
}

}  // namespace specula
