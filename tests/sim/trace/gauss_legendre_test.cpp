#include "sim/trace/gauss_legendre.hpp"

#include <cmath>
#include <numeric>

#include "sim/core/expect.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

double integral_of_power(const GaussRule& rule, int power) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * std::pow(rule.nodes[i], power);
    return sum;
}

TEST_CASE("n Gauss points integrate every polynomial of degree 2n - 1", "[trace]") {
    double worst = 0.0;
    for (int n = 1; n <= largest_gauss_rule; ++n) {
        const GaussRule& rule = gauss_legendre(n);
        for (int power = 0; power < 2 * n; ++power) {
            const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
            worst = std::max(worst, std::abs(integral_of_power(rule, power) - exact));
        }
    }
    CHECK(worst < 1e-13);  // rounding of 128 terms; 2e-15 seen
}

TEST_CASE("n Gauss points miss degree 2n by the known remainder", "[trace]") {
    // Abramowitz and Stegun 25.4.30: 2^(2n+1) (n!)^4 / ((2n+1) ((2n)!)^2) for x^2n.
    for (int n = 1; n <= 8; ++n) {
        const double factorial = std::tgamma(n + 1.0), twice = std::tgamma(2.0 * n + 1.0);
        const double missed =
            std::pow(2.0, 2 * n + 1) * std::pow(factorial, 4) / ((2.0 * n + 1.0) * twice * twice);
        const double exact = 2.0 / (2.0 * n + 1.0);
        CHECK(exact - integral_of_power(gauss_legendre(n), 2 * n) ==
              Approx(missed).epsilon(1e-9));  // difference of numbers of order 1, missed > 1e-5
    }
}

TEST_CASE("Gauss points stand in order, symmetric about the middle, weights positive", "[trace]") {
    for (int n = 1; n <= largest_gauss_rule; ++n) {
        const GaussRule& rule = gauss_legendre(n);
        REQUIRE(rule.nodes.size() == static_cast<std::size_t>(n));
        REQUIRE(rule.weights.size() == rule.nodes.size());
        bool good = rule.nodes.front() > -1.0 && rule.nodes.back() < 1.0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const std::size_t mirrored = rule.nodes.size() - 1 - i;
            good = good && (i == 0 || rule.nodes[i] > rule.nodes[i - 1]);
            good = good && std::abs(rule.nodes[i] + rule.nodes[mirrored]) < 1e-15;
            good = good && rule.weights[i] > 0.0;
            good = good && std::abs(rule.weights[i] - rule.weights[mirrored]) < 1e-14;
        }
        INFO(n << " points");
        CHECK(good);
    }
}

TEST_CASE("a rule of no points or of too many is our own mistake", "[trace]") {
    CHECK_THROWS_AS(gauss_legendre(0), BrokenPromise);
    CHECK_THROWS_AS(gauss_legendre(largest_gauss_rule + 1), BrokenPromise);
}

}  // namespace
}  // namespace specula
