#pragma once

#include <complex>
#include <vector>

#include "sim/core/chebyshev.hpp"
#include "sim/trace/scatter.hpp"

namespace specula {

/// Where the moments of a scatter are taken.
struct MomentGrid {
    ChebyshevGrid frequency_hz;   ///< nodes at which the sums are made
    ChebyshevGrid cos_incidence;  ///< interval and number of polynomials
    double reference_path_m;      ///< taken out of every phase
};

/// Sums over the points of a pair on a route without events, with no material in them:
/// S_p(f) = Sum_i weight_i T_p(cos_i) factor_i exp(-j(k(f) - centre) (path_i - reference)).
/// The incident part has one polynomial only. Layout (polynomial, frequency node).
struct Moments {
    std::vector<std::complex<double>> incident;  ///< (frequency)
    std::vector<std::complex<double>> te;        ///< (polynomial, frequency)
    std::vector<std::complex<double>> tm;        ///< (polynomial, frequency)
};

Moments moments_of(const PairScatter& pair, const MomentGrid& grid);

}  // namespace specula
