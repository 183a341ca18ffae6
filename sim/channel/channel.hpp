#pragma once

#include <complex>
#include <span>
#include <vector>

#include "sim/channel/reflector.hpp"
#include "sim/core/for_each.hpp"
#include "sim/trace/scatter.hpp"

namespace specula {

/// Equally spaced frequencies, those of the samples of a chirp.
struct FrequencyComb {
    double first_hz = 0.0;
    double step_hz = 0.0;
    int n = 0;

    double at(int i) const { return first_hz + step_hz * i; }
    double last_hz() const { return at(n - 1); }
};

/// What the propagation does to a wave between TX port and RX port, before any electronics:
/// complex amplitude transfer h = b/a, |h|^2 = received over transmitted power.
struct Channel {
    int n_rx = 0;
    int n_frequencies = 0;
    std::vector<Complex> h;         ///< (rx, frequency)
    double reference_path_m = 0.0;  ///< middle of the straight paths in it

    const Complex* of_rx(int rx) const {
        return &h[static_cast<std::size_t>(rx) * static_cast<std::size_t>(n_frequencies)];
    }
    Complex* of_rx(int rx) {
        return &h[static_cast<std::size_t>(rx) * static_cast<std::size_t>(n_frequencies)];
    }
};

/// The surface integral at every frequency of the comb, all routes together.
///
/// For the waves that meet one surface only, the sum over points is made at so few frequencies as
/// the spread of paths allows and for Chebyshev polynomials of the cosine of incidence; both are
/// then interpolated, the coefficients entering at their own frequency and angle. The others are
/// summed at every frequency. Error against the plain sum: below 1e-6 of the largest value.
/// @in  reflectors  (body)
/// @in  for_each    who sums frequency by frequency; the result does not depend on it by a bit
/// @eq  PHYSICS.md#surface-integral, #moments
Channel channel_of(const Scatter& scatter, std::span<const Reflector> reflectors,
                   const FrequencyComb& comb, const ForEach& for_each = one_by_one);

/// The plain sum at one frequency for one RX: what channel_of must agree with.
Complex direct_sum(const Scatter& scatter, int rx, std::span<const Reflector> reflectors,
                   double frequency_hz);

}  // namespace specula
