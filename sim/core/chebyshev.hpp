#pragma once

#include <span>
#include <vector>

namespace specula {

/// An interval and Chebyshev's points of the first kind in it.
struct ChebyshevGrid {
    double low = -1.0;
    double high = 1.0;
    int n = 1;

    double node(int i) const;
    std::vector<double> nodes() const;
    /// Maps [low, high] to [-1, 1].
    double unit(double x) const;
};

/// Number of points that interpolate exp(j a x) on [-1, 1] to 1e-9 (a up to 300): the Chebyshev
/// coefficients J_n(a) fall faster than any power beyond n = a.
int points_for_phase(double a_rad);

/// (node, target): value at a target = Sum over the nodes of matrix(node, target) * value there.
/// Barycentric form (Berrut and Trefethen 2004); a target on a node gets that node alone.
std::vector<double> interpolation_matrix(const ChebyshevGrid& grid,
                                         std::span<const double> targets);

/// T_0(x) .. T_{n-1}(x) for x in [-1, 1].
void chebyshev_polynomials(double x, std::span<double> values);

/// Row k of (k, node): coefficient of T_k = Sum_i matrix(k, i) * value at node i. Made once for
/// each n, and kept.
/// @in  n  1 to most_coefficients
const std::vector<double>& coefficient_matrix(int n);
inline constexpr int most_coefficients = 256;

}  // namespace specula
