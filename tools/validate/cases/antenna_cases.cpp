#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/antenna_integral.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// The n for which the pattern falls as cos^n from the boresight to a direction.
double exponent(const Pattern& pattern, const Vector3& direction, double cosine) {
    const double boresight = gain_towards(pattern, {0.0, 0.0, -1.0});
    return std::log(gain_towards(pattern, direction) / boresight) / std::log(cosine);
}

}  // namespace

std::vector<Quantity> pattern_integral_point(const CasePoint& point) {
    constexpr Range angle_deg{.min = 1.0, .max = 90.0, .max_excluded = true};
    const PatchPattern patch{
        .gain_dbi = point.inp.number("G0_dbi"),
        .half_width_azimuth_rad = point.inp.number("az6_deg", angle_deg) * pi / 180.0,
        .half_width_elevation_rad = point.inp.number("el6_deg", angle_deg) * pi / 180.0};
    const Pattern pattern = patch;
    const double integral = gain_over_sphere(patch);
    const double share = integral / (4.0 * pi);
    const double cosine = std::cos(0.5), sine = std::sin(0.5);  // anywhere off the axis
    Comparison compare(point);
    compare.relative("integral_G_dOmega", integral, "rel");
    compare.relative("efficiency", share, "rel");
    if (compare.wants("directivity_dbi")) {
        const double tolerance_db =
            power_db(1.0 + point.tolerance.number("rel", Range::at_least(0.0)));
        const double boresight = gain_towards(pattern, {0.0, 0.0, -1.0});
        compare.within("directivity_dbi", power_db(boresight / share), {tolerance_db, "dB"});
    }
    compare.relative("nA", exponent(pattern, {sine, 0.0, -cosine}, cosine), "rel");
    compare.relative("nE", exponent(pattern, {0.0, sine, -cosine}, cosine), "rel");
    return compare.finish();
}

std::vector<Quantity> intercepted_power_point(const CasePoint& point) {
    const Pattern pattern = antenna_of(point.inp, "antenna");
    const double length_m = point.inp.number("L_m", Range::above(0.0));
    const PlateBelow plate{.size_x_m = length_m,
                           .size_y_m = point.inp.number_or("Ly_m", length_m, Range::above(0.0)),
                           .height_m = point.inp.number("H_m", Range::above(0.0))};
    if (std::max(plate.size_x_m, plate.size_y_m) > 1000.0 * plate.height_m)
        throw NotComputable("integrates over plates of a thousand heights at most");
    const bool isotropic = std::holds_alternative<IsotropicPattern>(pattern);
    Comparison compare(point);
    compare.relative("fraction", intercepted_share(pattern, plate), "rel");
    if (isotropic) compare.relative("closed_form", solid_angle_share(plate), "rel");
    return compare.finish();
}

}  // namespace specula
