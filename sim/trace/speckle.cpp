#include "sim/trace/speckle.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/thin_plate.hpp"
#include "sim/trace/thin_points.hpp"

namespace specula {

namespace {

/// Larger bodies get larger cells, not more.
constexpr double most_cells = 250'000.0;
/// cos^2 of the angle beyond which the Kirchhoff slope factor is no longer followed.
const double grazing_cos_squared = std::pow(std::cos(70.0 * pi / 180.0), 2);

/// Cosine between the normal and the directions to TX and RX.
double cosine_between(const LitNode& node, const NodeView& view) {
    return (view.to_rx - node.arriving).normalized().dot(node.normal);
}

struct Cell {
    LitNode node;
    double area_m2;
};

/// A rotation rounds a size that is a multiple of the side to either side of it; the piece must not
/// have other cells for that.
int n_along(const Vector3& half, double side_m) {
    constexpr double rounding = 1e-9;
    return std::max(1, static_cast<int>(2.0 * half.norm() / side_m * (1.0 + rounding)));
}

double area_m2(const Surface& surface) {
    return 4.0 * surface_point(surface, 0.0, 0.0).area_normal().norm();
}

double cell_side_m(double total_m2, double correlation_m) {
    return std::max({smallest_cell_m, correlation_m, std::sqrt(total_m2 / most_cells)});
}

std::vector<Cell> cells_of(const Body& body, const PlacedAntenna& tx, double correlation_m) {
    double total_m2 = 0.0;
    for (const Surface& surface : body.surfaces) total_m2 += area_m2(surface);
    const double side_m = cell_side_m(total_m2, correlation_m);
    const NodeLighter lit_by(tx);
    std::vector<Cell> cells;
    for (const Surface& surface : body.surfaces) {
        const SurfacePoint middle = surface_point(surface, 0.0, 0.0);
        const int n_u = n_along(middle.along_u, side_m), n_v = n_along(middle.along_v, side_m);
        for (int j = 0; j < n_v; ++j) {
            for (int i = 0; i < n_u; ++i) {
                const LitNode node = lit_by(surface_point(surface, (2.0 * i + 1.0) / n_u - 1.0,
                                                          (2.0 * j + 1.0) / n_v - 1.0));
                cells.push_back({node, node.stretch_m2 * 4.0 / (n_u * n_v)});
            }
        }
    }
    return cells;
}

/// Adds the cell to the pair; with zero weight where one of the antennas is behind it.
void add_cell(const Cell& cell, const NodeViewer& seen_from, bool clear, PairScatter& pair) {
    const LitNode& node = cell.node;
    const NodeView view = seen_from(node);
    pair.path_m.push_back(node.r1_m + view.r2_m);
    if (!clear || !(node.arriving.dot(node.normal) < 0.0) || !(view.to_rx.dot(node.normal) > 0.0)) {
        pair.cos_incidence.push_back(1.0);
        for (std::vector<double>& weight : pair.weight) weight.push_back(0.0);
        return;
    }
    const double cosine = cosine_between(node, view);
    // Slopes of the heights turn facets towards the antennas: 1 / cos^2 in Kirchhoff's integral.
    const double spread = std::sqrt(cell.area_m2) /
                          (node.r1_m * view.r2_m * std::max(cosine * cosine, grazing_cos_squared));
    pair.cos_incidence.push_back(std::min(1.0, cosine));
    pair.weight[0].push_back(0.0);  // the unreflected part scatters forwards only
    pair.weight[1].push_back(view.weights.te * spread);
    pair.weight[2].push_back(view.weights.tm * spread);
}

RouteScatter empty_route(const RoughLayer& layer, std::size_t n_rx) {
    RouteScatter route{.route = {.before = {},
                                 .body = layer.body,
                                 .from_behind = false,
                                 .after = {},
                                 .rough_face = layer.face},
                       .rx = std::vector<PairScatter>(n_rx)};
    for (PairScatter& pair : route.rx) pair.weight.resize(route.route.n_weights());
    return route;
}

/// Middles of n equal parts of [-1, 1], seen from n_thin Chebyshev points.
ThinPoints::Axis cell_axis(int n, int n_thin) {
    std::vector<double> middles;
    for (int i = 0; i < n; ++i) middles.push_back((2.0 * i + 1.0) / n - 1.0);
    const std::vector<double> alike(middles.size(), 1.0);
    return thin_axis({-1.0, 1.0, n_thin}, std::move(middles), alike);
}

/// Thin points must be fewer than this share of the cells.
constexpr double worth_while_of_cells = 0.5;

}  // namespace

std::optional<RouteScatter> drawn_thin_cells(ThinPlate& plate, const RoughLayer& layer,
                                             Stream& piece) {
    const Surface surface = plate.surface();
    const SurfacePoint middle = surface_point(surface, 0.0, 0.0);
    const double side_m = cell_side_m(area_m2(surface), layer.correlation_m);
    const int n_u = n_along(middle.along_u, side_m), n_v = n_along(middle.along_v, side_m);
    const PointCount thin = plate.counts().thin;
    if (thin.u * thin.v > worth_while_of_cells * n_u * n_v) return std::nullopt;
    const auto& [lit, seen] = plate.nodes();
    for (const std::vector<NodeView>& views : seen)
        for (std::size_t i = 0; i < lit.size(); ++i) {
            const double cosine = cosine_between(lit[i], views[i]);
            if (cosine * cosine < grazing_cos_squared) return std::nullopt;  // a kink lies there
        }

    // A pair of normal numbers over sqrt(2) is an amplitude of mean square 1 and an even phase.
    std::vector<double> numbers(2 * static_cast<std::size_t>(n_u) * static_cast<std::size_t>(n_v));
    piece.fill_normal(numbers);
    std::vector<std::complex<double>> amplitudes;
    amplitudes.reserve(numbers.size() / 2);
    for (std::size_t i = 0; i < numbers.size(); i += 2)
        amplitudes.push_back(std::sqrt(0.5) * std::complex<double>(numbers[i], numbers[i + 1]));

    const AntennaSet& antennas = plate.antennas();
    RouteScatter route = empty_route(layer, antennas.rx.size());
    const ThinPoints points(surface, cell_axis(n_u, thin.u), cell_axis(n_v, thin.v));
    for (std::size_t rx = 0; rx < antennas.rx.size(); ++rx) {
        const PhaseCentres centres{antennas.tx.position_m, antennas.rx[rx].position_m};
        route.rx[rx].centre_rad_m = plate.detail().centre_rad_m;
        route.rx[rx].factor = points.weights(centres, plate.detail().centre_rad_m, amplitudes);
        for (std::size_t i = 0; i < lit.size(); ++i) {
            const NodeView& view = seen[rx][i];
            const double cosine = cosine_between(lit[i], view);
            const double cell_m2 = lit[i].stretch_m2 * 4.0 / (n_u * n_v);
            append(lit[i], view,
                   {.spread = std::sqrt(cell_m2) / (lit[i].r1_m * view.r2_m * cosine * cosine),
                    .cos_incidence = cosine},
                   route.rx[rx]);
        }
        // The unreflected part scatters forwards only.
        std::fill(route.rx[rx].weight[0].begin(), route.rx[rx].weight[0].end(), 0.0);
    }
    return route;
}

RouteScatter diffuse_cells(const Target& target, const AntennaSet& antennas,
                           const RoughLayer& layer) {
    const std::vector<Cell> cells = cells_of(target.bodies()[static_cast<std::size_t>(layer.body)],
                                             antennas.tx, layer.correlation_m);
    std::vector<Vector3> places;
    for (const Cell& cell : cells) places.push_back(cell.node.point_m);
    std::vector<char> lit(cells.size(), 1);
    const PlateSurface* plate = target.lone_plate();
    const bool may_hide = !plate || !is_seen_whole(*plate, antennas);
    if (may_hide) target.geometry().shadow(antennas.tx.position_m, places, lit);

    RouteScatter route = empty_route(layer, antennas.rx.size());
    for (std::size_t rx = 0; rx < antennas.rx.size(); ++rx) {
        std::vector<char> clear = lit;
        if (may_hide) target.geometry().shadow(antennas.rx[rx].position_m, places, clear);
        const NodeViewer seen_from(antennas.rx[rx]);
        for (std::size_t i = 0; i < cells.size(); ++i)
            add_cell(cells[i], seen_from, clear[i] != 0, route.rx[rx]);
    }
    return route;
}

void draw_speckle(RouteScatter& cells, Stream& piece) {
    const std::size_t n = cells.rx.empty() ? 0 : cells.rx.front().path_m.size();
    std::vector<std::complex<double>> amplitudes(n);
    for (std::complex<double>& amplitude : amplitudes) {
        const double size = std::sqrt(-std::log(piece.uniform()));  // Rayleigh, mean square 1
        amplitude = std::polar(size, two_pi * piece.uniform());
    }
    for (PairScatter& pair : cells.rx) pair.factor = amplitudes;
}

}  // namespace specula
