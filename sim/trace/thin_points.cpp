#include "sim/trace/thin_points.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/kernels.hpp"
#include "sim/trace/gauss_legendre.hpp"

namespace specula {

namespace {

ThinPoints::Axis axis_of(const double (&ends)[2], int n_dense, int n_thin) {
    const double low = ends[0], high = ends[1];
    const GaussRule& rule = gauss_legendre(n_dense);
    std::vector<double> dense, weights;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        dense.push_back(0.5 * ((high - low) * rule.nodes[i] + low + high));
        weights.push_back(0.5 * (high - low) * rule.weights[i]);
    }
    return thin_axis({low, high, n_thin}, std::move(dense), weights);
}

/// Without the derivatives.
Vector3 place_on(const Surface& surface, double u, double v) {
    const auto* on = std::get_if<PlateSurface>(&surface);
    if (!on) return surface_point(surface, u, v).point_m;
    const double x = 0.5 * on->plate.size_x_m * u, y = 0.5 * on->plate.size_y_m * v;
    return on->placement.point({x, y, on->plate.height_m(x, y)});
}

}  // namespace

ThinPoints::Axis thin_axis(const ChebyshevGrid& thin, std::vector<double> dense,
                           const std::vector<double>& weights) {
    const std::vector<double> by_node = interpolation_matrix(thin, dense);
    const std::size_t n_dense = dense.size(), n_thin = static_cast<std::size_t>(thin.n);
    ThinPoints::Axis axis{.dense = std::move(dense), .n_thin = n_thin, .lagrange = {}};
    axis.lagrange.resize(n_dense * n_thin);
    for (std::size_t i = 0; i < n_dense; ++i)
        for (std::size_t k = 0; k < n_thin; ++k)
            axis.lagrange[i * n_thin + k] = by_node[k * n_dense + i] * weights[i];
    return axis;
}

ThinPoints ThinPoints::of_patch(const Surface& surface, const Patch& patch,
                                const ThinCounts& counts) {
    return {surface, axis_of(patch.u, counts.dense.u, counts.thin.u),
            axis_of(patch.v, counts.dense.v, counts.thin.v)};
}

ThinPoints::ThinPoints(const Surface& surface, Axis u, Axis v)
    : u_(std::move(u)), v_(std::move(v)), row_(Kernels::padded(u_.dense.size())) {
    const std::size_t n = row_ * v_.dense.size();
    x_.resize(n);
    y_.resize(n);
    z_.resize(n);
    for (std::size_t j = 0; j < v_.dense.size(); ++j)
        for (std::size_t i = 0; i < u_.dense.size(); ++i) {
            const Vector3 point = place_on(surface, u_.dense[i], v_.dense[j]);
            x_[j * row_ + i] = point.x();
            y_[j * row_ + i] = point.y();
            z_[j * row_ + i] = point.z();
        }
}

/// @out  waves  (v; real parts by u, imaginary parts by u)
void ThinPoints::fill_waves(const PhaseCentres& centres, double wavenumber_rad_m,
                            std::vector<double>& waves) const {
    const Vector3 &from = centres.source_m, &to = centres.rx_m;
    std::vector<double> turns(x_.size());
    kernels().paths({x_.data(), y_.data(), z_.data(), x_.size()},
                    {{from.x(), from.y(), from.z()}, {to.x(), to.y(), to.z()}}, turns.data());
    const double turns_per_m = -wavenumber_rad_m / two_pi;
    for (double& turn : turns) turn *= turns_per_m;
    waves.resize(2 * turns.size());
    for (std::size_t j = 0; j < v_.dense.size(); ++j)
        kernels().turn(&turns[j * row_], row_, &waves[2 * j * row_], &waves[(2 * j + 1) * row_]);
}

/// Along v first, then along u.
std::vector<std::complex<double>> ThinPoints::gathered(std::vector<double>& waves) const {
    const std::size_t n_u = u_.n_thin, n_v = v_.n_thin;
    std::vector<double> rows(n_v * 2 * row_);
    kernels().add_products({v_.dense.size(), n_v, 2 * row_}, v_.lagrange.data(), waves.data(),
                           rows.data());
    const std::size_t n_columns = Kernels::padded(2 * n_v);
    std::vector<double> columns(u_.dense.size() * n_columns), sums(n_u * n_columns);
    for (std::size_t i = 0; i < u_.dense.size(); ++i)
        for (std::size_t b = 0; b < n_v; ++b) {
            columns[i * n_columns + b] = rows[2 * b * row_ + i];
            columns[i * n_columns + n_v + b] = rows[(2 * b + 1) * row_ + i];
        }
    kernels().add_products({u_.dense.size(), n_u, n_columns}, u_.lagrange.data(), columns.data(),
                           sums.data());
    std::vector<std::complex<double>> weights;
    weights.reserve(n_u * n_v);
    for (std::size_t b = 0; b < n_v; ++b)
        for (std::size_t a = 0; a < n_u; ++a)
            weights.emplace_back(sums[a * n_columns + b], sums[a * n_columns + n_v + b]);
    return weights;
}

std::vector<std::complex<double>> ThinPoints::weights(const PhaseCentres& centres,
                                                      double wavenumber_rad_m) const {
    std::vector<double> waves;
    fill_waves(centres, wavenumber_rad_m, waves);
    return gathered(waves);
}

std::vector<std::complex<double>> ThinPoints::weights(
    const PhaseCentres& centres, double wavenumber_rad_m,
    const std::vector<std::complex<double>>& factors) const {
    std::vector<double> waves;
    fill_waves(centres, wavenumber_rad_m, waves);
    const std::size_t n_u = u_.dense.size();
    for (std::size_t j = 0; j < v_.dense.size(); ++j)
        for (std::size_t i = 0; i < n_u; ++i) {
            double& re = waves[2 * j * row_ + i];
            double& im = waves[(2 * j + 1) * row_ + i];
            const std::complex<double> product =
                std::complex<double>(re, im) * factors[j * n_u + i];
            re = product.real();
            im = product.imag();
        }
    return gathered(waves);
}

}  // namespace specula
