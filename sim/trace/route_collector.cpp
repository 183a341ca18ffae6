#include "sim/trace/route_collector.hpp"

#include <algorithm>
#include <cmath>

#include "sim/trace/physical_optics.hpp"
#include "sim/trace/polarisation.hpp"

namespace specula {

namespace {

Route route_of(const Walk& walk, int body) {
    Route route{.before = {}, .body = body, .from_behind = walk.from_behind, .after = {}};
    for (const EventAt& at : walk.before) route.before.push_back(at.event);
    for (const EventAt& at : walk.after) route.after.push_back(at.event);
    return route;
}

FieldParts arriving_fields(const Vector3& tx_field, const std::vector<EventAt>& events) {
    FieldParts parts{tx_field};
    for (const EventAt& at : events)
        parts = at.event.kind == Event::Kind::reflect
                    ? after_reflection(parts, at.direction, at.normal)
                    : after_transmission(parts, at.direction, at.normal);
    return parts;
}

/// What the RX is sensitive to behind the sheets on the last leg: seen from the RX, they come in
/// reverse order.
FieldParts received_fields(const Vector3& rx_field, const std::vector<EventAt>& events) {
    FieldParts parts{rx_field};
    for (auto at = events.rbegin(); at != events.rend(); ++at)
        parts = after_transmission(parts, at->direction, at->normal);
    // Parts count the events from the RX backwards; weights count them in the wave's order.
    if (events.size() < 2) return parts;
    FieldParts ordered(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::size_t reversed = 0;
        for (std::size_t bit = 0; bit < events.size(); ++bit)
            if (i >> bit & 1u) reversed |= std::size_t{1} << (events.size() - 1 - bit);
        ordered[reversed] = parts[i];
    }
    return ordered;
}

}  // namespace

PairScatter& RouteCollector::pair_of(const Route& route, std::size_t rx) {
    const auto found = std::find_if(scatter_.routes.begin(), scatter_.routes.end(),
                                    [&](const RouteScatter& r) { return r.route == route; });
    if (found != scatter_.routes.end()) return found->rx[rx];
    RouteScatter fresh{route, std::vector<PairScatter>(antennas_.rx.size())};
    for (PairScatter& pair : fresh.rx) {
        pair.event_cosine.resize(route.n_events());
        pair.weight.resize(route.n_weights());
    }
    scatter_.routes.push_back(std::move(fresh));
    return scatter_.routes.back().rx[rx];
}

void RouteCollector::add_straight(const WeightedPoint& point, int body, const StraightWay& way,
                                  std::size_t rx) {
    const PlacedAntenna &tx = antennas_.tx, &receiver = antennas_.rx[rx];
    const double r1 = (point.point_m - tx.position_m).norm();
    const Vector3 to_rx = receiver.position_m - point.point_m;
    const double r2 = to_rx.norm();
    const BounceWeights w = bounce_weights({.to_point = way.arriving,
                                            .to_rx = to_rx / r2,
                                            .normal = way.normal,
                                            .tx_field = tx_pattern_(way.arriving),
                                            .rx_field = rx_patterns_[rx](-to_rx / r2)});
    const double spread = point.area_m2 / (r1 * r2);
    PairScatter& pair =
        pair_of({.before = {}, .body = body, .from_behind = way.from_behind, .after = {}}, rx);
    pair.path_m.push_back(r1 + r2);
    pair.cos_incidence.push_back(std::min(1.0, -way.arriving.dot(way.normal)));
    pair.weight[0].push_back(w.incident * spread);
    pair.weight[1].push_back(w.te * spread);
    pair.weight[2].push_back(w.tm * spread);
}

void RouteCollector::add(const WeightedPoint& point, int body, const Walk& walk,
                         const Vector3& source_m, std::size_t rx) {
    const PlacedAntenna& receiver = antennas_.rx[rx];
    const Vector3 to_rx = receiver.position_m - point.point_m;
    const double r1 = (point.point_m - source_m).norm(), r2 = to_rx.norm();
    PairScatter& pair = pair_of(route_of(walk, body), rx);
    pair.path_m.push_back(r1 + r2);
    pair.cos_incidence.push_back(std::min(1.0, -walk.arriving.dot(walk.normal)));
    std::size_t event = 0;
    for (const auto* events : {&walk.before, &walk.after})
        for (const EventAt& at : *events)
            pair.event_cosine[event++].push_back(
                std::min(1.0, std::abs(at.direction.dot(at.normal))));

    const FieldParts arriving =
        arriving_fields(antennas_.tx.field_towards(walk.leaving), walk.before);
    const FieldParts received = received_fields(receiver.field_towards(-to_rx / r2), walk.after);
    const double spread = point.area_m2 / (r1 * r2);
    for (std::size_t before = 0; before < arriving.size(); ++before) {
        for (std::size_t after = 0; after < received.size(); ++after) {
            const BounceWeights w = bounce_weights({.to_point = walk.arriving,
                                                    .to_rx = to_rx / r2,
                                                    .normal = walk.normal,
                                                    .tx_field = arriving[before],
                                                    .rx_field = received[after]});
            const double parts[3] = {w.incident, w.te, w.tm};
            for (std::size_t k = 0; k < 3; ++k)
                pair.weight[(before * 3 + k) * received.size() + after].push_back(parts[k] *
                                                                                  spread);
        }
    }
}

}  // namespace specula
