#include "tools/likeness/least_squares.hpp"

#include <cmath>

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("a straight line through scattered points is the textbook's", "[likeness]") {
    const std::vector<double> x{0, 1, 2, 3, 4}, y{1.0, 2.9, 5.2, 6.8, 9.1};
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    const double slope = (5 * sxy - sx * sy) / (5 * sxx - sx * sx);
    const Columns columns{std::vector<double>(5, 1.0), x};
    const auto found = least_squares(columns, y);
    CHECK(found[1] == Approx(slope));
    CHECK(found[0] == Approx((sy - slope * sx) / 5));
    double sum = 0.0;
    for (const double rest : unexplained(columns, found, y)) sum += rest;
    CHECK(sum == Approx(0.0).margin(1e-12));  // orthogonal to the constant
}

TEST_CASE("a pair explains what least squares says it takes from the residual", "[likeness]") {
    const std::size_t n = 40;
    std::vector<double> one(n, 1.0), a, b, y;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i);
        a.push_back(std::cos(0.3 * t));
        b.push_back(std::sin(0.3 * t) + 0.2);
        y.push_back(std::cos(0.35 * t) + 0.01 * t);
    }
    const auto energy = [](const std::vector<double>& v) {
        double sum = 0.0;
        for (const double x : v) sum += x * x;
        return sum;
    };
    const auto rest = unexplained({one}, least_squares({one}, y), y);
    const double after = energy(unexplained({one, a, b}, least_squares({one, a, b}, y), y));
    ExplainedSpace space;
    space.add(one);
    CHECK(space.gain(a, b, rest) == Approx(energy(rest) - after));
    space.add(a);
    space.add(b);
    CHECK(space.gain(a, b, rest) == 0.0);  // nothing new
}

}  // namespace
}  // namespace specula
