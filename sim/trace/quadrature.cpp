#include "sim/trace/quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// A patch this small against its distance has one rate of phase all over.
constexpr double small_angle = 0.05;
/// Part of the accuracy asked for that the points of a patch may use up.
constexpr double share_of_points = 0.03;

/// Points on [-1, 1] for exp(jau) and a relative error: J_n(a) is about Ai(x) (2/a)^(1/3) at
/// n = a + x (a/2)^(1/3), and Ai(x) about exp(-2/3 x^(3/2)).
/// What is left of a patch after its phases have met is about 1/a of it, so the error must be.
int points_for(double a_rad, double share) {
    const double error = share / (1.0 + a_rad);
    if (a_rad * a_rad / 6.0 < error) return 1;
    const double x = std::pow(1.5 * std::log(1.0 / error), 2.0 / 3.0);
    return static_cast<int>(std::ceil(0.5 * (a_rad + x * std::cbrt(0.5 * a_rad)))) + 1;
}

}  // namespace

PointCount points_needed(const Surface& surface, const Patch& patch, const PhaseCentres& centres,
                         double wavelength_m, double accuracy_db) {
    const SurfacePoint middle = surface_point(surface, patch.u_at(0.0), patch.v_at(0.0));
    const double size_m =
        (patch.half_u() * middle.along_u).norm() + (patch.half_v() * middle.along_v).norm();
    const double distance_m = std::min((middle.point_m - centres.source_m).norm(),
                                       (middle.point_m - centres.rx_m).norm());
    const int looks = size_m < small_angle * distance_m ? 3 : 9;
    double rate_u = 0.0, rate_v = 0.0;
    for (int i = 0; i < looks; ++i) {
        for (int j = 0; j < looks; ++j) {
            const double s = -1.0 + 2.0 * i / (looks - 1), t = -1.0 + 2.0 * j / (looks - 1);
            const SurfacePoint at = surface_point(surface, patch.u_at(s), patch.v_at(t));
            const Vector3 pull = (at.point_m - centres.source_m).normalized() +
                                 (at.point_m - centres.rx_m).normalized();
            rate_u = std::max(rate_u, std::abs(pull.dot(at.along_u)) * std::sqrt(1.0 - s * s));
            rate_v = std::max(rate_v, std::abs(pull.dot(at.along_v)) * std::sqrt(1.0 - t * t));
        }
    }
    const double k = two_pi / wavelength_m;
    const double share = share_of_points * (std::pow(10.0, accuracy_db / 20.0) - 1.0);
    const bool is_triangle = std::holds_alternative<TriangleSurface>(surface);
    // A triangle's area element grows along u, so one point would sit off its centroid.
    return {std::max(is_triangle ? 2 : 1, points_for(k * rate_u * patch.half_u(), share)),
            points_for(k * rate_v * patch.half_v(), share)};
}

}  // namespace specula
