#include "sim/trace/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// Over a patch this small against its distance the rate of phase changes evenly: few looks do.
constexpr double small_angle = 0.05;
/// Nobody has use for more thin points per axis: they are many themselves by then.
constexpr int most_thin_points = 4096;
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

/// A patch looked at from a source, at some points of it.
class Looks {
  public:
    /// @in  rx_m  those that `rates` will be asked for
    Looks(const Surface& surface, const Patch& patch, const Vector3& source_m,
          std::span<const Vector3> rx_m);

    /// @in  cosine_m  how many metres of path a change of the cosine of incidence counts as much as
    Rates rates(const Vector3& rx_m, double cosine_m) const;

  private:
    struct Look {
        SurfacePoint at;
        double spacing_u, spacing_v;          ///< of quadrature points there
        double from_source_u, from_source_v;  ///< change of the distance to the source
        double of_cosine_u, of_cosine_v;      ///< about that of the cosine of incidence
    };
    static constexpr int most_per_axis = 9;
    Vector3 middle_m_;
    double size_m_, from_source_m_, farthest_;
    std::array<Look, most_per_axis * most_per_axis> looks_;
    std::size_t n_looks_ = 0;
};

Looks::Looks(const Surface& surface, const Patch& patch, const Vector3& source_m,
             std::span<const Vector3> rx_m) {
    const SurfacePoint middle = surface_point(surface, patch.u_at(0.0), patch.v_at(0.0));
    middle_m_ = middle.point_m;
    size_m_ = (patch.half_u() * middle.along_u).norm() + (patch.half_v() * middle.along_v).norm();
    from_source_m_ = (middle_m_ - source_m).norm();
    double nearest_m = from_source_m_;
    for (const Vector3& rx : rx_m) nearest_m = std::min(nearest_m, (middle_m_ - rx).norm());
    const bool small = size_m_ < small_angle * nearest_m;
    const int n = small ? 3 : most_per_axis;
    // Straight below the antennas the rate is nothing in the middle and grows to both sides, most
    // of it, weighted, at sqrt(1/2).
    farthest_ = small ? std::sqrt(0.5) : 1.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double s = farthest_ * (2.0 * i / (n - 1) - 1.0);
            const double t = farthest_ * (2.0 * j / (n - 1) - 1.0);
            const SurfacePoint at = surface_point(surface, patch.u_at(s), patch.v_at(t));
            const Vector3 from_source = at.point_m - source_m;
            const double r = from_source.norm();
            const double u = from_source.dot(at.along_u) / r, v = from_source.dot(at.along_v) / r;
            looks_[n_looks_++] = {at,   std::sqrt(1.0 - s * s), std::sqrt(1.0 - t * t), u, v, u / r,
                                  v / r};
        }
    }
}

Rates Looks::rates(const Vector3& rx_m, double cosine_m) const {
    Rates rates;
    rates.size_m = size_m_;
    rates.distance_m = std::min(from_source_m_, (middle_m_ - rx_m).norm());
    rates.farthest = farthest_;
    for (const Look& look : std::span(looks_).first(n_looks_)) {
        const Vector3 from_rx = (look.at.point_m - rx_m).normalized();
        const double u =
            look.from_source_u + cosine_m * look.of_cosine_u + from_rx.dot(look.at.along_u);
        const double v =
            look.from_source_v + cosine_m * look.of_cosine_v + from_rx.dot(look.at.along_v);
        rates.u = std::max(rates.u, std::abs(u) * look.spacing_u);
        rates.v = std::max(rates.v, std::abs(v) * look.spacing_v);
        rates.spread_u.take(u);
        rates.spread_v.take(v);
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
    return std::min(most_thin_points, for_phase + static_cast<int>(std::ceil(smooth)));
}

/// What a patch asks for of points_needed.
struct Request {
    const Surface& surface;
    const Patch& patch;
    double wavenumber_rad_m;
    double share;
};

PointCount dense_points(const Rates& rates, const Request& asked) {
    // Seen under a wide angle, a patch is not equally bright all over.
    const int fewest =
        rates.size_m * rates.size_m < asked.share * rates.distance_m * rates.distance_m ? 1 : 2;
    const bool is_triangle = std::holds_alternative<TriangleSurface>(asked.surface);
    const double k = asked.wavenumber_rad_m;
    // A triangle's area element grows along u, so one point would sit off its centroid.
    return {std::max(is_triangle ? 2 : fewest,
                     points_for(rates.along_u(k, asked.patch.half_u()), asked.share)),
            std::max(fewest, points_for(rates.along_v(k, asked.patch.half_v()), asked.share))};
}

PointCount most_of(const PointCount& a, const PointCount& b) {
    return {std::max(a.u, b.u), std::max(a.v, b.v)};
}

}  // namespace

PointCount points_needed(const Surface& surface, const Patch& patch, const PhaseCentres& centres,
                         double wavelength_m, double accuracy_db) {
    const Looks looks(surface, patch, centres.source_m, {&centres.rx_m, 1});
    return dense_points(looks.rates(centres.rx_m, 0.0),
                        {surface, patch, two_pi / wavelength_m, share_of(accuracy_db)});
}

ThinCounts thin_points_needed(const Surface& surface, const Patch& patch, const Vector3& source_m,
                              std::span<const Vector3> rx_m, const Detail& detail,
                              double accuracy_db) {
    const double error = share_of(accuracy_db);
    const double half_band_rad_m = detail.half_band_rad_m;
    const double highest_rad_m = detail.centre_rad_m + half_band_rad_m;
    const double cosine_m = highest_rad_m * detail.layer_path_m / half_band_rad_m;
    const Looks looks(surface, patch, source_m, rx_m);
    ThinCounts most{{1, 1}, {1, 1}};
    for (const Vector3& rx : rx_m) {
        const PointCount dense =
            dense_points(looks.rates(rx, 0.0), {surface, patch, highest_rad_m, error});
        const Rates rates = looks.rates(rx, cosine_m);
        // Patterns and spread have their nearest singularity a distance away across the patch.
        const double away = rates.distance_m / (0.5 * rates.size_m);
        const double smooth =
            std::log(1.0 / error) / std::log(away + std::sqrt(away * away + 1.0)) / 2.0;
        const PointCount thin{
            thin_points_for(rates.along_u(half_band_rad_m, patch.half_u()), smooth, error),
            thin_points_for(rates.along_v(half_band_rad_m, patch.half_v()), smooth, error)};
        most = {most_of(most.dense, dense), most_of(most.thin, thin)};
    }
    return most;
}

}  // namespace specula
