#pragma once

#include <vector>

namespace specula {

/// Nodes and weights on [-1, 1]; exact for polynomials of degree 2n - 1.
struct GaussRule {
    std::vector<double> nodes;
    std::vector<double> weights;
};

/// The rule with n nodes, 1 <= n <= largest_gauss_rule; made once, then shared.
const GaussRule& gauss_legendre(int n);

inline constexpr int largest_gauss_rule = 128;

}  // namespace specula
