#include "sim/trace/edge_trace.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/free_edge.hpp"
#include "sim/trace/gauss_legendre.hpp"

namespace specula {

namespace {

/// A piece whose ends are not equally visible is halved until it is this small.
constexpr double smallest_piece_wavelengths = 0.1;
/// Points of a piece: a phase that turns by `most_turn_rad` is summed to 1e-9.
constexpr int points_of_piece = 16;
constexpr double most_turn_rad = 12.0;
/// Where visibility is looked at, however short a piece is.
constexpr int looks_at_turn = 9;

/// A part of an edge's parameter.
struct Piece {
    double low;
    double high;
    double at(double s) const { return 0.5 * ((high - low) * s + high + low); }
    double half() const { return 0.5 * (high - low); }
};

/// One edge between the TX and one RX.
class EdgeTracer {
  public:
    EdgeTracer(const Target& target, const AntennaSet& antennas, const TraceSettings& settings)
        : target_(target),
          antennas_(antennas),
          wavelength_m_(speed_of_light_m_s / settings.highest_hz) {}

    void add(const FreeEdge& edge, const PlacedAntenna& rx, const Piece& piece,
             PairScatter& pair) const {
        const double size_m = 2.0 * piece.half() * edge.at(piece.at(0.0)).stretch_m;
        const std::vector<FreeEdge::Place> places = places_on(edge, piece);
        const std::vector<char> seen = seen_of(places, rx);
        const bool mixed =
            !std::all_of(seen.begin(), seen.end(), [&](char each) { return each == seen.front(); });
        const bool can_be_cut = size_m > smallest_piece_wavelengths * wavelength_m_;
        if (turn_rad(edge, piece, rx) > most_turn_rad || (mixed && can_be_cut)) {
            add(edge, rx, {piece.low, piece.at(0.0)}, pair);
            add(edge, rx, {piece.at(0.0), piece.high}, pair);
            return;
        }
        const GaussRule& rule = gauss_legendre(points_of_piece);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (seen[i]) add(places[i], rx, piece.half() * rule.weights[i], pair);
    }

  private:
    std::vector<FreeEdge::Place> places_on(const FreeEdge& edge, const Piece& piece) const {
        std::vector<FreeEdge::Place> places;
        for (const double node : gauss_legendre(points_of_piece).nodes)
            places.push_back(edge.at(piece.at(node)));
        return places;
    }

    /// How far the phase runs over a piece.
    double turn_rad(const FreeEdge& edge, const Piece& piece, const PlacedAntenna& rx) const {
        double low = 0.0, high = 0.0;
        for (int i = 0; i < looks_at_turn; ++i) {
            const double s = 2.0 * i / (looks_at_turn - 1) - 1.0;
            const Vector3 point = edge.at(piece.at(s * (1.0 - 1e-9))).point_m;
            const double path_m =
                (point - antennas_.tx.position_m).norm() + (point - rx.position_m).norm();
            low = i == 0 ? path_m : std::min(low, path_m);
            high = i == 0 ? path_m : std::max(high, path_m);
        }
        return two_pi * (high - low) / wavelength_m_;
    }

    std::vector<char> seen_of(const std::vector<FreeEdge::Place>& places,
                              const PlacedAntenna& rx) const {
        std::vector<Vector3> points;
        std::vector<char> seen;
        for (const FreeEdge::Place& place : places) {
            const Vector3& normal = place.frame.normal;
            points.push_back(place.point_m);
            seen.push_back(normal.dot(antennas_.tx.position_m - place.point_m) *
                               normal.dot(rx.position_m - place.point_m) >
                           0.0);
        }
        target_.geometry().shadow(antennas_.tx.position_m, points, seen);
        target_.geometry().shadow(rx.position_m, points, seen);
        return seen;
    }

    void add(const FreeEdge::Place& place, const PlacedAntenna& rx, double share,
             PairScatter& pair) const {
        const Vector3 from_tx = place.point_m - antennas_.tx.position_m;
        const Vector3 to_rx = rx.position_m - place.point_m;
        const double r1 = from_tx.norm(), r2 = to_rx.norm();
        const EdgeBounce bounce{from_tx / r1, to_rx / r2};
        EdgeFrame frame = place.frame;
        if (frame.normal.dot(from_tx) > 0.0) frame.normal = -frame.normal;
        const Vector3 current =
            fringe_current(frame, bounce, antennas_.tx.field_towards(bounce.arriving));
        // The RX's field is at right angles to the ray: of the current, only that part radiates.
        const double received = rx.field_towards(-bounce.leaving).dot(current);
        pair.path_m.push_back(r1 + r2);
        pair.weight[0].push_back(received * share * place.stretch_m / (r1 * r2));
    }

    const Target& target_;
    const AntennaSet& antennas_;
    double wavelength_m_;
};

}  // namespace

std::vector<EdgeScatter> trace_edges(const Target& target, const AntennaSet& antennas,
                                     const TraceSettings& settings) {
    const EdgeTracer tracer(target, antennas, settings);
    std::vector<EdgeScatter> scatter;
    for (std::size_t body = 0; body < target.bodies().size(); ++body) {
        const std::vector<FreeEdge> edges = free_edges(target.bodies()[body]);
        EdgeScatter of_body{static_cast<int>(body), std::vector<PairScatter>(antennas.rx.size())};
        for (std::size_t rx = 0; rx < antennas.rx.size(); ++rx) {
            of_body.rx[rx].weight.resize(1);
            for (const FreeEdge& edge : edges)
                tracer.add(edge, antennas.rx[rx], {-1.0, 1.0}, of_body.rx[rx]);
        }
        scatter.push_back(std::move(of_body));
    }
    return scatter;
}

}  // namespace specula
