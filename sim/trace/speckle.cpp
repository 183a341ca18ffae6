#include "sim/trace/speckle.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/physical_optics.hpp"

namespace specula {

namespace {

constexpr double smallest_cell_m = 1e-3;
constexpr int most_terms = 400;

struct Cell {
    Vector3 point_m;
    Vector3 normal;
    double area_m2;
    double amplitude;  ///< Rayleigh, mean square 1
    double phase_rad;
};

/// The cells of a piece: their number and random amplitudes do not depend on where the piece lies.
std::vector<Cell> cells_of(const RoughFace& face, Stream& piece) {
    const double side_m = std::max(face.correlation_m, smallest_cell_m);
    const int n_x = std::max(1, static_cast<int>(face.plate.size_x_m / side_m));
    const int n_y = std::max(1, static_cast<int>(face.plate.size_y_m / side_m));
    std::vector<Cell> cells;
    for (int j = 0; j < n_y; ++j) {
        for (int i = 0; i < n_x; ++i) {
            const double x = face.plate.size_x_m * ((i + 0.5) / n_x - 0.5);
            const double y = face.plate.size_y_m * ((j + 0.5) / n_y - 0.5);
            const Vector3 normal = face.plate.area_normal(x, y);
            const double stretch = normal.norm();
            cells.push_back(
                {.point_m = face.placement.point({x, y, face.plate.height_m(x, y)}),
                 .normal = face.placement.direction(normal / stretch),
                 .area_m2 = stretch * face.plate.size_x_m / n_x * face.plate.size_y_m / n_y,
                 .amplitude = std::sqrt(-std::log(piece.uniform())),
                 .phase_rad = two_pi * piece.uniform()});
        }
    }
    return cells;
}

}  // namespace

double diffuse_cross_section(const RoughFace& face, double cos_incidence, double frequency_hz) {
    const double k = two_pi * frequency_hz / speed_of_light_m_s;
    const double sine = std::sqrt(std::max(0.0, 1.0 - cos_incidence * cos_incidence));
    const double x = std::pow(2.0 * k * face.rms_m * cos_incidence, 2);
    const double across = std::pow(2.0 * k * face.correlation_m * sine, 2);
    // Terms x^n e^{-x} / n! by logarithms: x may be large.
    double log_term = -x, sum = 0.0;
    for (int n = 1; n <= most_terms; ++n) {
        log_term += std::log(x / n);
        const double spectrum =
            face.correlation_m * face.correlation_m / (2.0 * n) * std::exp(-across / (4.0 * n));
        const double term = std::exp(log_term) * spectrum;
        sum += term;
        if (n > x && term < 1e-12 * sum) break;
    }
    return 2.0 * k * k / (cos_incidence * cos_incidence) * sum;
}

void add_speckle(Scatter& scatter, const Target& target, const RoughFace& face,
                 const AntennaSet& antennas, double frequency_hz, int smooth_body,
                 Stream& piece) {
    if (face.rms_m == 0.0) return;
    const double wavelength_m = speed_of_light_m_s / frequency_hz;
    const std::vector<Cell> cells = cells_of(face, piece);
    std::vector<Vector3> places;
    for (const Cell& cell : cells) places.push_back(cell.point_m);

    RouteScatter diffuse;
    diffuse.route.body = smooth_body;
    for (const PlacedAntenna& rx : antennas.rx) {
        PairScatter pair;
        pair.weight.resize(diffuse.route.n_weights());
        std::vector<char> clear(cells.size(), 1);
        target.geometry().shadow(antennas.tx.position_m, places, clear);
        target.geometry().shadow(rx.position_m, places, clear);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Cell& cell = cells[i];
            const Vector3 from_tx = cell.point_m - antennas.tx.position_m;
            const Vector3 to_rx = rx.position_m - cell.point_m;
            const double r1 = from_tx.norm(), r2 = to_rx.norm();
            const double cosine = -from_tx.dot(cell.normal) / r1;
            if (!clear[i] || !(cosine > 0.0) || !(to_rx.dot(cell.normal) > 0.0)) continue;
            const Vector3 tx_field = antennas.tx.field_towards(from_tx / r1);
            const Vector3 rx_field = rx.field_towards(-to_rx / r2);
            // |h|^2 = lambda^2 G_t G_r sigma0 A / ((4 pi)^3 r1^2 r2^2); the prefactor of the surface
            // integral, 1 / (8 pi), is taken out again.
            const double sigma0 = diffuse_cross_section(face, cosine, frequency_hz);
            const double spread = 8.0 * pi * wavelength_m *
                                  std::sqrt(sigma0 * cell.area_m2 / std::pow(4.0 * pi, 3)) /
                                  (r1 * r2);
            pair.path_m.push_back(r1 + r2 + wavelength_m * cell.phase_rad / two_pi);
            pair.cos_incidence.push_back(std::min(1.0, cosine));
            pair.weight[0].push_back(0.0);
            pair.weight[1].push_back(0.0);
            pair.weight[2].push_back(cell.amplitude * spread * tx_field.dot(rx_field));
        }
        diffuse.rx.push_back(std::move(pair));
    }
    scatter.routes.push_back(std::move(diffuse));
}

}  // namespace specula
