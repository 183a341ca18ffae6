#pragma once

#include <optional>

#include "sim/channel/coefficients.hpp"

namespace specula {

/// TE and TM coefficients over an interval of frequencies and one of cosines, as double series of
/// Chebyshev polynomials: coefficient = Sum_pk c(p, k) T_p(cosine) T_k(frequency).
/// @eq PHYSICS.md#moments
struct CoefficientTable {
    ChebyshevGrid cosine;         ///< its n: how many polynomials
    ChebyshevGrid frequency_hz;   ///< likewise
    std::vector<Complex> te, tm;  ///< (cosine polynomial, frequency polynomial)

    /// The series over the cosine at frequencies in the interval: (frequency, cosine polynomial).
    AngularSeries at(std::span<const double> frequencies_hz) const;
};

/// As many terms as leave out nothing above 1e-9; nothing where that takes more than
/// `most_polynomials` of the cosine or a third as many of the frequency.
/// @in  cosine, frequency_hz  intervals; their n is not looked at
std::optional<CoefficientTable> coefficient_table(const Event& event, const Reflector& reflector,
                                                  ChebyshevGrid cosine, ChebyshevGrid frequency_hz);

}  // namespace specula
