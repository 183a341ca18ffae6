#pragma once

#include <complex>
#include <vector>

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
    struct Counts {
        PointCount dense;  ///< each at most largest_gauss_rule
        PointCount thin;
    };
    /// Gauss-Legendre points for an integral over the patch's parameters u and v.
    static ThinPoints of_patch(const Surface& surface, const Patch& patch, const Counts& counts);

    /// Where smooth factors are asked for: parameters of the surface, (v, u).
    struct Node {
        double u;
        double v;
    };
    const std::vector<Node>& nodes() const { return nodes_; }
    /// (node) W for these phase centres at a wave number.
    std::vector<std::complex<double>> weights(const PhaseCentres& centres,
                                              double wavenumber_rad_m) const;

    /// Along one axis: the many points with their weights, seen from the few.
    struct Axis {
        std::vector<double> dense;     ///< parameters of the many
        std::vector<double> thin;      ///< parameters of the few
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
    std::vector<Node> nodes_;
};

/// Lagrange polynomials through n Chebyshev points of an interval, at other points of it.
struct AxisInterval {
    double low;
    double high;
};
ThinPoints::Axis thin_axis(const AxisInterval& interval, int n_thin, std::vector<double> dense,
                           const std::vector<double>& weights);

}  // namespace specula
