#pragma once

#include <complex>
#include <vector>

#include "sim/core/chebyshev.hpp"
#include "sim/trace/quadrature.hpp"

namespace specula {

/// A patch of a surface as a grid of many points, at which a phase is followed, and one of few
/// Chebyshev points, through which all smooth factors are interpolated.
///
/// Sum over the many of weight * exp(-jk path) * smooth = Sum over the few of W * smooth, with
/// W = Sum over the many of weight * exp(-jk path) * the few's Lagrange polynomials.
/// @eq PHYSICS.md#thinned-quadrature
class ThinPoints {
  public:
    /// Gauss-Legendre points for an integral over the patch's parameters u and v.
    /// @in  counts  dense: each at most largest_gauss_rule
    static ThinPoints of_patch(const Surface& surface, const Patch& patch,
                               const ThinCounts& counts);

    /// (v, u of the few) W for these phase centres at a wave number.
    std::vector<std::complex<double>> weights(const PhaseCentres& centres,
                                              double wavenumber_rad_m) const;

    /// Along one axis: the many points with their weights, seen from the few.
    struct Axis {
        std::vector<double> dense;  ///< parameters of the many
        std::size_t n_thin;
        std::vector<double> lagrange;  ///< (dense, thin), weights included
    };
    /// Any grid; its points lie on the surface at the axes' parameters.
    ThinPoints(const Surface& surface, Axis u, Axis v);

    /// Each of the many points has a factor of its own besides: (v, u), complex.
    std::vector<std::complex<double>> weights(
        const PhaseCentres& centres, double wavenumber_rad_m,
        const std::vector<std::complex<double>>& factors) const;

  private:
    std::vector<std::complex<double>> gathered(std::vector<double>& waves) const;
    void fill_waves(const PhaseCentres& centres, double wavenumber_rad_m,
                    std::vector<double>& waves) const;

    Axis u_, v_;
    std::size_t row_;                ///< of the dense grid, padded
    std::vector<double> x_, y_, z_;  ///< (v, u) of the many
};

/// Lagrange polynomials through the nodes of a grid, at points of its interval, times their
/// weights.
ThinPoints::Axis thin_axis(const ChebyshevGrid& thin, std::vector<double> dense,
                           const std::vector<double>& weights);

}  // namespace specula
