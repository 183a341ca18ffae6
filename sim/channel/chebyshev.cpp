#include "sim/channel/chebyshev.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

double ChebyshevGrid::node(int i) const {
    return 0.5 * (low + high) + 0.5 * (high - low) * std::cos(pi * (i + 0.5) / n);
}

double ChebyshevGrid::unit(double x) const {
    return high > low ? (2.0 * x - low - high) / (high - low) : 0.0;
}

int points_for_phase(double a_rad) {
    return static_cast<int>(std::ceil(a_rad + 6.0 * std::cbrt(a_rad))) + 9;
}

std::vector<double> interpolation_matrix(const ChebyshevGrid& grid,
                                         std::span<const double> targets) {
    const std::size_t n = static_cast<std::size_t>(grid.n);
    std::vector<double> matrix(targets.size() * n, 0.0), node(n), share(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        node[i] = grid.node(static_cast<int>(i));
        share[i] = sign * std::sin(pi * (static_cast<double>(i) + 0.5) / grid.n);
    }
    for (std::size_t row = 0; row < targets.size(); ++row) {
        double* weights = &matrix[row * n];
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double distance = targets[row] - node[i];
            if (distance == 0.0) {
                std::fill(weights, weights + n, 0.0);
                weights[i] = sum = 1.0;
                break;
            }
            weights[i] = share[i] / distance;
            sum += weights[i];
        }
        for (std::size_t i = 0; i < n; ++i) weights[i] /= sum;
    }
    return matrix;
}

void chebyshev_polynomials(double x, std::span<double> values) {
    values[0] = 1.0;
    if (values.size() > 1) values[1] = x;
    for (std::size_t k = 2; k < values.size(); ++k)
        values[k] = 2.0 * x * values[k - 1] - values[k - 2];
}

std::vector<double> coefficient_matrix(int n) {
    // All angles are multiples of pi / (2 n).
    const auto points = static_cast<std::size_t>(n), turn = 4 * points;
    std::vector<double> cosine(turn), matrix(points * points);
    for (std::size_t m = 0; m < turn; ++m)
        cosine[m] = std::cos(0.5 * pi * static_cast<double>(m) / n);
    for (std::size_t k = 0; k < points; ++k)
        for (std::size_t i = 0; i < points; ++i)
            matrix[k * points + i] = (k == 0 ? 1.0 : 2.0) / n * cosine[k * (2 * i + 1) % turn];
    return matrix;
}

}  // namespace specula
