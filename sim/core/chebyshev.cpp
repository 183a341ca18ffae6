#include "sim/core/chebyshev.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/made_once.hpp"

namespace specula {

namespace {

constexpr double error_of_phase = 1e-9;

}  // namespace

double ChebyshevGrid::node(int i) const {
    return 0.5 * (low + high) + 0.5 * (high - low) * std::cos(pi * (i + 0.5) / n);
}

double ChebyshevGrid::unit(double x) const {
    return high > low ? (2.0 * x - low - high) / (high - low) : 0.0;
}

int points_for_phase(double a_rad) {
    // Interpolation through n points errs by 4 J_n(a) at most, and little more where J_n falls
    // fast; J_n(a) < (a/2)^n / n!, or, for large a, by Airy's function (quadrature.cpp).
    const int enough = static_cast<int>(std::ceil(a_rad + 6.0 * std::cbrt(a_rad))) + 9;
    int n = 1;
    for (double bound = 2.0 * a_rad; bound > error_of_phase && n < enough; ++n)
        bound *= 0.5 * a_rad / (n + 1);
    return n;
}

std::vector<double> ChebyshevGrid::nodes() const {
    std::vector<double> all;
    for (int i = 0; i < n; ++i) all.push_back(node(i));
    return all;
}

std::vector<double> interpolation_matrix(const ChebyshevGrid& grid,
                                         std::span<const double> targets) {
    const std::size_t n = targets.size();
    const std::vector<double> nodes = grid.nodes();
    std::vector<double> matrix(nodes.size() * n), sum(n, 0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double share =
            (i % 2 == 0 ? 1.0 : -1.0) * std::sin(pi * (static_cast<double>(i) + 0.5) / grid.n);
        double* row = &matrix[i * n];
        for (std::size_t target = 0; target < n; ++target) {
            row[target] = share / (targets[target] - nodes[i]);
            sum[target] += row[target];
        }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t target = 0; target < n; ++target) matrix[i * n + target] /= sum[target];
    for (std::size_t target = 0; target < n; ++target) {
        if (std::isfinite(sum[target])) continue;  // no division by zero, so not on a node
        const auto on = std::find(nodes.begin(), nodes.end(), targets[target]) - nodes.begin();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            matrix[i * n + target] = static_cast<std::ptrdiff_t>(i) == on ? 1.0 : 0.0;
    }
    return matrix;
}

void chebyshev_polynomials(double x, std::span<double> values) {
    values[0] = 1.0;
    if (values.size() > 1) values[1] = x;
    for (std::size_t k = 2; k < values.size(); ++k)
        values[k] = 2.0 * x * values[k - 1] - values[k - 2];
}

namespace {

std::vector<double> make_coefficient_matrix(int n) {
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

}  // namespace

const std::vector<double>& coefficient_matrix(int n) {
    SPECULA_EXPECT(n >= 1 && n <= most_coefficients);
    static MadeOnce<std::vector<double>, most_coefficients> matrices;
    return matrices(n, make_coefficient_matrix);
}

}  // namespace specula
