#include "tools/validate/formulas/antenna_integral.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"

namespace specula {

namespace {

/// Integral over a rectangle in equal panels of Gauss-Legendre points. Each panel is stretched by
/// (3 s - s^3) / 2, which gathers points at its ends: roots there, as gains of patches have at 90
/// degrees, then cost nothing.
struct Span {
    double low, high;
    int panels;
};
template <typename Integrand>
double integral(const Span& u, const Span& v, const Integrand& integrand) {
    const GaussRule& rule = gauss_legendre(24);
    const auto nodes = [&](const Span& span, const auto& visit) {
        const double half = 0.5 * (span.high - span.low) / span.panels;
        for (int panel = 0; panel < span.panels; ++panel)
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double s = rule.nodes[i];
                visit(span.low + half * (2.0 * panel + 1.0 + 0.5 * s * (3.0 - s * s)),
                      half * rule.weights[i] * 1.5 * (1.0 - s * s));
            }
    };
    double sum = 0.0;
    nodes(u, [&](double x, double weight_x) {
        nodes(v, [&](double y, double weight_y) { sum += weight_x * weight_y * integrand(x, y); });
    });
    return sum;
}

}  // namespace

double gain_over_sphere(const PatchPattern& patch) {
    // Panels are no wider than the beam, and end at the boresight and at 90 degrees.
    const auto quarter = [](double half_width_rad) {
        return std::max(2, static_cast<int>(std::ceil(0.5 * pi / half_width_rad)));
    };
    const Span azimuth{-pi, pi, 4 * quarter(patch.half_width_azimuth_rad)};
    const Span elevation{-0.5 * pi, 0.5 * pi, 2 * quarter(patch.half_width_elevation_rad)};
    return integral(azimuth, elevation, [&](double az, double el) {
        const Vector3 direction(std::cos(el) * std::sin(az), std::sin(el),
                                -std::cos(el) * std::cos(az));
        return patch.gain(direction) * std::cos(el);
    });
}

double intercepted_share(const Pattern& pattern, const PlateBelow& plate) {
    // Panels of half the height: the integrand varies over lengths of the height.
    const auto span = [&](double size_m) {
        return Span{-0.5 * size_m, 0.5 * size_m,
                    std::clamp(static_cast<int>(std::ceil(2.0 * size_m / plate.height_m)), 2, 200)};
    };
    return integral(span(plate.size_x_m), span(plate.size_y_m), [&](double x, double y) {
        const Vector3 to_plate(x, y, -plate.height_m);
        const double r = to_plate.norm();
        return gain_towards(pattern, to_plate / r) * plate.height_m / (4.0 * pi * r * r * r);
    });
}

double solid_angle_share(const PlateBelow& plate) {
    const double a = 0.5 * plate.size_x_m, b = 0.5 * plate.size_y_m, h = plate.height_m;
    return std::atan(a * b / (h * std::sqrt(a * a + b * b + h * h))) / pi;
}

}  // namespace specula
