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
    double reference_path_m;      ///< taken out of what the frequency turns
};

/// Sums over the points of a pair on a route without events, with no material in them:
/// S_p(f) = Sum_i weight_i T_p(cos_i) wave_i(k_m) exp(-j(k(f) - k_m) (path_i - reference)),
/// k_m at the middle of the interval of frequencies, wave_i as PairScatter::wave.
/// The incident part has one polynomial only. Layout (polynomial, frequency node).
struct Moments {
    std::vector<std::complex<double>> incident;  ///< (frequency)
    std::vector<std::complex<double>> te;        ///< (polynomial, frequency)
    std::vector<std::complex<double>> tm;        ///< (polynomial, frequency)
};

Moments moments_of(const PairScatter& pair, const MomentGrid& grid);

}  // namespace specula
