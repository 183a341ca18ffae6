#include "sim/trace/gauss_legendre.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/made_once.hpp"

namespace specula {

namespace {

/// Newton's method on the Legendre polynomial from Tricomi's estimate of its roots.
GaussRule make_rule(int n) {
    GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
    for (int i = 0; i < n; ++i) {
        double x = std::cos(pi * (i + 0.75) / (n + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 8; ++step) {
            double now = 1.0, before = 0.0;
            for (int k = 0; k < n; ++k) {
                const double next = ((2 * k + 1) * x * now - k * before) / (k + 1);
                before = now;
                now = next;
            }
            slope = n * (x * now - before) / (x * x - 1.0);
            x -= now / slope;
        }
        rule.nodes[n - 1 - i] = x;
        rule.weights[n - 1 - i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
    return rule;
}

}  // namespace

const GaussRule& gauss_legendre(int n) {
    SPECULA_EXPECT(n >= 1 && n <= largest_gauss_rule);
    static MadeOnce<GaussRule, largest_gauss_rule> rules;
    return rules(n, make_rule);
}

}  // namespace specula
