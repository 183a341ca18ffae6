#include "sim/core/chebyshev.hpp"

#include <cmath>
#include <complex>

#include "tests/check.hpp"

namespace specula {
namespace {

std::vector<double> targets_in(const ChebyshevGrid& grid, int n) {
    std::vector<double> targets;
    for (int i = 0; i < n; ++i)
        targets.push_back(grid.low + (grid.high - grid.low) * i / (n - 1.0));
    return targets;
}

TEST_CASE("the number of points that a phase asks for interpolates it to 1e-9", "[channel]") {
    for (const double a_rad : {0.0, 0.1, 1.0, 3.0, 10.0, 31.4, 100.0, 300.0}) {
        const ChebyshevGrid grid{-1.0, 1.0, points_for_phase(a_rad)};
        const auto targets = targets_in(grid, 501);
        const auto matrix = interpolation_matrix(grid, targets);
        double worst = 0.0;
        for (std::size_t row = 0; row < targets.size(); ++row) {
            std::complex<double> sum = 0.0;
            for (int i = 0; i < grid.n; ++i)
                sum += matrix[static_cast<std::size_t>(i) * targets.size() + row] *
                       std::polar(1.0, a_rad * grid.node(i));
            worst = std::max(worst, std::abs(sum - std::polar(1.0, a_rad * targets[row])));
        }
        INFO("phase " << a_rad << ", " << grid.n << " points");
        CHECK(worst < 1e-9);  // as the docstring says; 6e-10 seen
    }
}

TEST_CASE("fewer points than radians of phase interpolate nothing", "[channel]") {
    const ChebyshevGrid grid{-1.0, 1.0, 90};
    const double target = 0.5 * (grid.node(44) + grid.node(45));
    const auto matrix = interpolation_matrix(grid, std::span(&target, 1));
    std::complex<double> sum = 0.0;
    for (int i = 0; i < grid.n; ++i)
        sum += matrix[static_cast<std::size_t>(i)] * std::polar(1.0, 100.0 * grid.node(i));
    CHECK(std::abs(sum - std::polar(1.0, 100.0 * target)) > 0.1);
}

TEST_CASE("interpolation on n points is exact for polynomials below degree n", "[channel]") {
    const ChebyshevGrid grid{57e9, 62e9, 7};
    const auto targets = targets_in(grid, 50);
    const auto matrix = interpolation_matrix(grid, targets);
    double worst = 0.0;
    for (int power = 0; power < grid.n; ++power)
        for (std::size_t row = 0; row < targets.size(); ++row) {
            double sum = 0.0;
            for (int i = 0; i < grid.n; ++i)
                sum += matrix[static_cast<std::size_t>(i) * targets.size() + row] *
                       std::pow(grid.unit(grid.node(i)), power);
            worst = std::max(worst, std::abs(sum - std::pow(grid.unit(targets[row]), power)));
        }
    CHECK(worst < 1e-12);  // rounding; 1e-15 seen
}

TEST_CASE("a target on a node gets that node alone, also in an interval of no width", "[channel]") {
    const ChebyshevGrid grid{-1.0, 1.0, 5};
    const double node = grid.node(2);
    CHECK(interpolation_matrix(grid, std::span(&node, 1)) == std::vector<double>{0, 0, 1, 0, 0});

    const ChebyshevGrid point{0.8, 0.8, 3};
    const double target = 0.8;
    const auto row = interpolation_matrix(point, std::span(&target, 1));
    CHECK(row[0] + row[1] + row[2] == 1.0);
    CHECK(point.unit(0.8) == 0.0);
}

TEST_CASE("Chebyshev polynomials are cosines of multiples of an angle", "[channel]") {
    std::vector<double> values(12);
    double worst = 0.0;
    for (double angle_rad = 0.0; angle_rad <= 3.1; angle_rad += 0.1) {
        chebyshev_polynomials(std::cos(angle_rad), values);
        for (std::size_t k = 0; k < values.size(); ++k)
            worst =
                std::max(worst, std::abs(values[k] - std::cos(static_cast<double>(k) * angle_rad)));
    }
    CHECK(worst < 1e-13);  // the recursion loses a digit near the ends
    chebyshev_polynomials(0.3, std::span(values).first(1));
    CHECK(values[0] == 1.0);
}

TEST_CASE("the coefficients of a Chebyshev polynomial are itself alone", "[channel]") {
    constexpr int n = 9;
    const ChebyshevGrid grid{-1.0, 1.0, n};
    const auto matrix = coefficient_matrix(n);
    double worst = 0.0;
    for (int of = 0; of < n; ++of) {
        std::vector<double> at_nodes, polynomials(n);
        for (int i = 0; i < n; ++i) {
            chebyshev_polynomials(grid.node(i), polynomials);
            at_nodes.push_back(polynomials[static_cast<std::size_t>(of)]);
        }
        for (int k = 0; k < n; ++k) {
            double coefficient = 0.0;
            for (int i = 0; i < n; ++i)
                coefficient += matrix[static_cast<std::size_t>(k * n + i)] *
                               at_nodes[static_cast<std::size_t>(i)];
            worst = std::max(worst, std::abs(coefficient - (k == of ? 1.0 : 0.0)));
        }
    }
    CHECK(worst < 1e-14);  // rounding
}

}  // namespace
}  // namespace specula
