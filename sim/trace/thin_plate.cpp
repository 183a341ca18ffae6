#include "sim/trace/thin_plate.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"
#include "sim/trace/thin_points.hpp"

namespace specula {

namespace {

/// Do few points pay, being fewer than a share of the many?
bool is_worth_while(const ThinCounts& counts) {
    constexpr double largest_share = 0.4;
    return counts.thin.u * counts.thin.v <= largest_share * counts.dense.u * counts.dense.v;
}

bool is_too_dense(const PointCount& dense) {
    return dense.u > largest_gauss_rule || dense.v > largest_gauss_rule;
}

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

/// What turns the integrand over the band of the settings.
Detail detail_of(const TraceSettings& settings) {
    const double low = two_pi * settings.lowest_hz / speed_of_light_m_s;
    const double high = two_pi * settings.highest_hz / speed_of_light_m_s;
    return {.centre_rad_m = 0.5 * (low + high),
            .half_band_rad_m = 0.5 * (high - low),
            .layer_path_m = settings.layer_path_m};
}

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

std::optional<ThinPlate> ThinPlate::of(const Target& target, const AntennaSet& antennas,
                                       const TraceSettings& settings) {
    const PlateSurface* plate = target.lone_plate();
    const bool has_band = settings.lowest_hz > 0.0 && settings.lowest_hz < settings.highest_hz;
    if (!plate || !has_band || !is_seen_whole(*plate, antennas)) return std::nullopt;
    if (!is_smooth_over(*plate, antennas.tx)) return std::nullopt;
    for (const PlacedAntenna& rx : antennas.rx)
        if (!is_smooth_over(*plate, rx)) return std::nullopt;
    return ThinPlate(*plate, target.bodies()[0].opaque, antennas, settings);
}

ThinPlate::ThinPlate(const PlateSurface& plate, bool is_opaque, const AntennaSet& antennas,
                     const TraceSettings& settings)
    : plate_(&plate),
      is_opaque_(is_opaque),
      antennas_(&antennas),
      accuracy_db_(settings.accuracy_db),
      detail_(detail_of(settings)) {
    for (const PlacedAntenna& rx : antennas.rx) rx_m_.push_back(rx.position_m);
    counts_ = counts_of({});
}

ThinCounts ThinPlate::counts_of(const Patch& patch) const {
    return thin_points_needed(*plate_, patch, antennas_->tx.position_m, rx_m_, detail_,
                              accuracy_db_);
}

const ThinNodes& ThinPlate::nodes() {
    if (!nodes_) nodes_ = thin_nodes(*plate_, {}, counts_.thin, *antennas_);
    return *nodes_;
}

std::optional<Scatter> ThinPlate::echo() {
    RouteScatter route;
    route.rx.resize(rx_m_.size());
    for (PairScatter& pair : route.rx) pair.weight.resize(route.route.n_weights());
    if (is_too_dense(counts_.dense)) {
        if (!add_halves({}, counts_.dense, route)) return std::nullopt;
    } else {
        if (!is_worth_while(counts_)) return std::nullopt;
        add_points({}, counts_, nodes(), route);
    }
    return Scatter{.n_rx = static_cast<int>(rx_m_.size()), .routes = {std::move(route)}};
}

bool ThinPlate::add(const Patch& patch, RouteScatter& route) const {
    const ThinCounts counts = counts_of(patch);
    if (is_too_dense(counts.dense)) return add_halves(patch, counts.dense, route);
    if (!is_worth_while(counts)) return false;
    add_points(patch, counts, thin_nodes(*plate_, patch, counts.thin, *antennas_), route);
    return true;
}

bool ThinPlate::add_halves(const Patch& patch, const PointCount& dense, RouteScatter& route) const {
    Patch first = patch, second = patch;
    if (dense.u > dense.v)
        first.u[1] = second.u[0] = patch.u_at(0.0);
    else
        first.v[1] = second.v[0] = patch.v_at(0.0);
    return add(first, route) && add(second, route);
}

void ThinPlate::add_points(const Patch& patch, const ThinCounts& counts, const ThinNodes& nodes,
                           RouteScatter& route) const {
    const ThinPoints points = ThinPoints::of_patch(*plate_, patch, counts);
    route.route.from_behind = nodes.lit.front().at_back && !is_opaque_;
    for (std::size_t rx = 0; rx < rx_m_.size(); ++rx) {
        PairScatter& pair = route.rx[rx];
        const auto sums =
            points.weights({antennas_->tx.position_m, rx_m_[rx]}, detail_.centre_rad_m);
        pair.centre_rad_m = detail_.centre_rad_m;
        pair.factor.insert(pair.factor.end(), sums.begin(), sums.end());
        for (std::size_t i = 0; i < nodes.lit.size(); ++i) {
            const LitNode& node = nodes.lit[i];
            const NodeView& view = nodes.seen[rx][i];
            append(node, view,
                   {.spread = node.stretch_m2 / (node.r1_m * view.r2_m),
                    .cos_incidence = -node.arriving.dot(node.normal)},
                   pair);
        }
    }
}

}  // namespace specula
