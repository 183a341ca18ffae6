#include "sim/trace/many_surfaces.hpp"

#include <algorithm>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"

namespace specula {

namespace {

constexpr std::size_t points_at_once = 4096;

}  // namespace

/// A patch of one of the surfaces, and where its points stand among those of all.
struct ManySurfaces::Piece {
    const Surface& surface;
    Patch patch;
    PointCount count;
    std::size_t first, n;
};

struct ManySurfaces::Straight {
    RouteCollector::StraightWay way;
    bool clear;
    bool at_back;

    bool is_like(const Straight& other) const {
        return clear == other.clear && (!clear || at_back == other.at_back);
    }
};

double ManySurfaces::wavelength_m() const {
    return speed_of_light_m_s / settings_.highest_hz;
}

std::vector<ManySurfaces::Straight> ManySurfaces::straight_ways(
    const Task& task, const std::vector<WeightedPoint>& points) const {
    const Vector3 &tx_m = antennas_.tx.position_m, &rx_m = antennas_.rx[task.rx].position_m;
    const bool is_sheet = !target_.body_of(task.face).opaque;
    std::vector<Straight> ways;
    std::vector<Vector3> places;
    ways.reserve(points.size());
    for (const WeightedPoint& p : points) {
        const Vector3 arriving = (p.point_m - tx_m).normalized();
        const bool at_back = arriving.dot(p.normal) > 0.0;
        const Vector3 normal = at_back ? Vector3(-p.normal) : p.normal;
        const bool faces_both = normal.dot(rx_m - p.point_m) > 0.0 && normal.dot(arriving) < 0.0;
        ways.push_back({{arriving, normal, at_back && is_sheet}, faces_both, at_back});
        if (faces_both) places.push_back(p.point_m);
    }
    std::vector<char> clear(places.size(), 1);
    target_.geometry().shadow(tx_m, places, clear);
    target_.geometry().shadow(rx_m, places, clear);
    std::size_t asked = 0;
    for (Straight& way : ways)
        if (way.clear) way.clear = clear[asked++] != 0;
    return ways;
}

/// Do all ways of a piece meet the same, as far as can be known, or is it cut no further?
bool ManySurfaces::is_settled(const Piece& piece, const std::vector<Straight>& ways) const {
    const auto begin = ways.begin() + static_cast<std::ptrdiff_t>(piece.first);
    const bool alike = std::all_of(begin, begin + static_cast<std::ptrdiff_t>(piece.n),
                                   [&](const Straight& way) { return way.is_like(*begin); });
    const bool known_between =
        target_.faces().size() == 1 || std::min(piece.count.u, piece.count.v) >= fewest_ways;
    if (alike && known_between) return true;
    const Patch& patch = piece.patch;
    const SurfacePoint middle = surface_point(piece.surface, patch.u_at(0.0), patch.v_at(0.0));
    const double size_m = 2.0 * std::max(patch.half_u() * middle.along_u.norm(),
                                         patch.half_v() * middle.along_v.norm());
    return size_m <= smallest_cut_wavelengths * wavelength_m();
}

void ManySurfaces::add(const Task& task, const Alone& alone) {
    const Face& face = target_.faces()[static_cast<std::size_t>(task.face)];
    const PhaseCentres centres{antennas_.tx.position_m, antennas_.rx[task.rx].position_m};
    std::vector<Piece> pieces;
    std::vector<WeightedPoint> points;
    const auto finish = [&] {
        const std::vector<Straight> ways = straight_ways(task, points);
        for (const Piece& piece : pieces) {
            if (!is_settled(piece, ways)) {
                alone(piece.surface, piece.patch);
                continue;
            }
            for (std::size_t i = piece.first; i < piece.first + piece.n; ++i)
                if (ways[i].clear) routes_.add_straight(points[i], face.body, ways[i].way, task.rx);
        }
        pieces.clear();
        points.clear();
    };
    for (const Surface& surface : face.surfaces)
        for (const Patch& patch : patches_of(surface)) {
            const PointCount count =
                points_needed(surface, patch, centres, wavelength_m(), settings_.accuracy_db);
            if (count.u > largest_gauss_rule || count.v > largest_gauss_rule) {
                alone(surface, patch);
                continue;
            }
            const std::size_t first = points.size();
            append_points_on(surface, patch, count, points);
            pieces.push_back({surface, patch, count, first, points.size() - first});
            if (points.size() >= points_at_once) finish();
        }
    finish();
}

}  // namespace specula
