#include "sim/trace/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// Over a patch this small against its distance the rate of phase changes evenly: few looks do.
constexpr double small_angle = 0.05;
/// Part of the accuracy asked for that the points of a patch may use up.
constexpr double share_of_points = 0.03;
/// The same for a single point per axis, whose error is known and not estimated.
constexpr double share_of_one_point = 0.3;

/// The order from which on J_n(z) is below an error: by (z/2)^n / n!, or, sharper for z > 1, by
/// J_n(z) ~ Ai(x) (2/z)^(1/3) at n = z + x (z/2)^(1/3) and Ai(x) < exp(-2/3 x^(3/2)).
int order_beyond(double z, double error) {
    const double x = std::pow(1.5 * std::log(1.0 / error), 2.0 / 3.0);
    const double enough = z + x * std::cbrt(0.5 * z);
    int n = 0;
    for (double bound = 1.0; bound > error && (z <= 1.0 || n < enough); ++n)
        bound *= 0.5 * z / (n + 1);
    return n;
}

/// A phase a u + q u^2 along one axis of a patch, u in [-1, 1].
struct Phase {
    double a_rad = 0.0;  ///< its largest rate, weighted by the spacing of the points
    double q_rad = 0.0;
};

/// n points are exact up to degree 2n - 1. The Chebyshev coefficients beyond are J_2n(a) of a
/// linear phase and J_n(q/2) of a quadratic one.
/// What is left of a patch after its phases have met is about 1/a of it, so the error must be.
int points_for(const Phase& phase, double share) {
    const double error = share / (1.0 + phase.a_rad);
    const double of_one_point = phase.a_rad * phase.a_rad / 6.0 + phase.q_rad / 3.0;
    if (of_one_point < share_of_one_point / share_of_points * error) return 1;
    const int n = std::max((order_beyond(phase.a_rad, error) + 1) / 2,
                           order_beyond(0.5 * phase.q_rad, error));
    return n <= 2 ? 2 : n + 1;  // one more for what is neither
}

/// Smallest and largest of what is looked at.
struct Spread {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// How fast a phase changes over a patch, per unit wave number.
struct Rates {
    double size_m = 0.0;      ///< half sides of the patch, added
    double distance_m = 0.0;  ///< of the nearer phase centre
    double farthest = 1.0;    ///< from the middle of the patch, as far as was looked
    double u = 0.0, v = 0.0;  ///< largest rates along the half sides, weighted
    Spread spread_u, spread_v;

    Phase along_u(double k_rad_m, double half) const {
        return {k_rad_m * u * half,
                k_rad_m * (spread_u.high - spread_u.low) * half / (4.0 * farthest)};
    }
    Phase along_v(double k_rad_m, double half) const {
        return {k_rad_m * v * half,
                k_rad_m * (spread_v.high - spread_v.low) * half / (4.0 * farthest)};
    }
};

/// @in  cosine_m  how many metres of path a change of the cosine of incidence counts as much as
Rates rates_over(const Surface& surface, const Patch& patch, const PhaseCentres& centres,
                 double cosine_m) {
    const SurfacePoint middle = surface_point(surface, patch.u_at(0.0), patch.v_at(0.0));
    Rates rates;
    rates.size_m =
        (patch.half_u() * middle.along_u).norm() + (patch.half_v() * middle.along_v).norm();
    rates.distance_m = std::min((middle.point_m - centres.source_m).norm(),
                                (middle.point_m - centres.rx_m).norm());
    const bool small = rates.size_m < small_angle * rates.distance_m;
    const int looks = small ? 3 : 9;
    // Straight below the antennas the rate is nothing in the middle and grows to both sides, most
    // of it, weighted, at sqrt(1/2).
    rates.farthest = small ? std::sqrt(0.5) : 1.0;
    for (int i = 0; i < looks; ++i) {
        for (int j = 0; j < looks; ++j) {
            const double s = rates.farthest * (2.0 * i / (looks - 1) - 1.0);
            const double t = rates.farthest * (2.0 * j / (looks - 1) - 1.0);
            const SurfacePoint at = surface_point(surface, patch.u_at(s), patch.v_at(t));
            const Vector3 from_source = at.point_m - centres.source_m;
            const double r1 = from_source.norm();
            Vector3 pull = from_source / r1 + (at.point_m - centres.rx_m).normalized();
            if (cosine_m > 0.0) pull += cosine_m / (r1 * r1) * from_source;
            const double along_u = pull.dot(at.along_u), along_v = pull.dot(at.along_v);
            rates.u = std::max(rates.u, std::abs(along_u) * std::sqrt(1.0 - s * s));
            rates.v = std::max(rates.v, std::abs(along_v) * std::sqrt(1.0 - t * t));
            rates.spread_u.take(along_u);
            rates.spread_v.take(along_v);
        }
    }
    return rates;
}

double share_of(double accuracy_db) {
    return share_of_points * (std::pow(10.0, accuracy_db / 20.0) - 1.0);
}

/// Interpolation through n points is exact up to degree n - 1, half of what quadrature is.
int thin_points_for(const Phase& phase, double smooth, double error) {
    const int for_phase =
        std::max(order_beyond(phase.a_rad, error), 2 * order_beyond(0.5 * phase.q_rad, error));
    return for_phase + static_cast<int>(std::ceil(smooth));
}

}  // namespace

PointCount points_needed(const Surface& surface, const Patch& patch, const PhaseCentres& centres,
                         double wavelength_m, double accuracy_db) {
    const Rates rates = rates_over(surface, patch, centres, 0.0);
    const double k = two_pi / wavelength_m;
    const double share = share_of(accuracy_db);
    // Seen under a wide angle, a patch is not equally bright all over.
    const int fewest =
        rates.size_m * rates.size_m < share * rates.distance_m * rates.distance_m ? 1 : 2;
    const bool is_triangle = std::holds_alternative<TriangleSurface>(surface);
    // A triangle's area element grows along u, so one point would sit off its centroid.
    return {std::max(is_triangle ? 2 : fewest, points_for(rates.along_u(k, patch.half_u()), share)),
            std::max(fewest, points_for(rates.along_v(k, patch.half_v()), share))};
}

PointCount thin_points_needed(const Surface& surface, const Patch& patch,
                              const PhaseCentres& centres, const Detail& detail,
                              double accuracy_db) {
    const double highest_rad_m = detail.centre_rad_m + detail.half_band_rad_m;
    const double cosine_m = highest_rad_m * detail.layer_path_m / detail.half_band_rad_m;
    const Rates rates = rates_over(surface, patch, centres, cosine_m);
    const double error = share_of(accuracy_db);
    // Patterns and spread have their nearest singularity a distance away across the patch.
    const double away = rates.distance_m / (0.5 * rates.size_m);
    const double smooth =
        std::log(1.0 / error) / std::log(away + std::sqrt(away * away + 1.0)) / 2.0;
    return {thin_points_for(rates.along_u(detail.half_band_rad_m, patch.half_u()), smooth, error),
            thin_points_for(rates.along_v(detail.half_band_rad_m, patch.half_v()), smooth, error)};
}

}  // namespace specula
