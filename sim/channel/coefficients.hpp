#pragma once

#include <span>
#include <vector>

#include "materials/transmission.hpp"
#include "sim/channel/reflector.hpp"
#include "sim/core/chebyshev.hpp"
#include "sim/trace/scatter.hpp"

namespace specula {

/// A pair of coefficients in the order of the weights' bits.
struct TeTm {
    Complex te;
    Complex tm;
};

/// The currents' coefficients of a body struck from the front or from behind. From behind, the
/// stack is turned over and its face lies nearer by its thickness.
/// @eq PHYSICS.md#sheets
TeTm reflection_of(const Stack& stack, double cos_incidence, bool from_behind);

/// The factor of a wave that passes a sheet, over what the same way in air would give.
/// @eq PHYSICS.md#sheets
TeTm transmission_of(const Stack& stack, double cos_incidence);

TeTm coefficients_of(const Event& event, const Stack& stack, double cos_incidence);

/// TE and TM coefficients at one frequency as series of Chebyshev polynomials of the cosine.
struct AngularSeries {
    std::vector<Complex> te, tm;  ///< (polynomial)
};

/// Of an event, or of the currents (then `event.kind` is reflect), over an interval of cosines.
AngularSeries angular_series(const Event& event, const Stack& stack, const ChebyshevGrid& cosines);

/// The largest number of polynomials that a series may have.
inline constexpr int most_polynomials = 192;
/// Coefficients of polynomials up to here are left out of a series.
inline constexpr double negligible_coefficient = 1e-8;

/// How many polynomials carry the angle dependence of a body over an interval of cosines, at the
/// given frequencies, with coefficients left out below 1e-8; at most `most_polynomials`. A thick
/// sheet of low loss needs many.
int polynomials_needed(const Event& event, const Reflector& reflector,
                       std::span<const double> frequencies_hz, ChebyshevGrid cosines);

}  // namespace specula
