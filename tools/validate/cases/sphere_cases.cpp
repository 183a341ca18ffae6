#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/mie_sphere.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// `ka`, or `radius_m` and `f_hz`.
double circumference_of(const Fields& inp) {
    constexpr Range sizes{.min = 0.0, .max = 1e5, .min_excluded = true};
    if (inp.has("ka") || !inp.has("radius_m")) return inp.number("ka", sizes);
    return two_pi * frequency_of(inp) / speed_of_light_m_s * inp.number("radius_m", sizes);
}

std::vector<Quantity> sphere_point(const CasePoint& point, double ka, double sigma_over_disc) {
    Comparison compare(point);
    compare.relative("sigma_over_pi_a2", sigma_over_disc, "rel");
    if (compare.wants("sigma_m2")) {
        const double radius_m = ka * speed_of_light_m_s / (two_pi * frequency_of(point.inp));
        compare.relative("sigma_m2", sigma_over_disc * pi * radius_m * radius_m, "rel");
    }
    return compare.finish();
}

}  // namespace

std::vector<Quantity> conducting_sphere_point(const CasePoint& point) {
    const double ka = circumference_of(point.inp);
    return sphere_point(point, ka, conducting_sphere_backscatter(ka));
}

std::vector<Quantity> dielectric_sphere_point(const CasePoint& point) {
    const double ka = circumference_of(point.inp);
    Complex index;
    if (point.inp.has("eps")) {
        index = std::sqrt(point.inp.permittivity("eps"));
        if (index.imag() > 0.0) index = -index;
    } else {
        index = point.inp.permittivity("refractive_index");
        if (index.real() < 0.0)
            point.inp.fail("refractive_index", "negative real part", "give n - j kappa, n >= 0");
    }
    if (std::abs(index) * ka > 1e7) throw NotComputable("sums spheres of |index| ka up to 1e7");
    return sphere_point(point, ka,
                        dielectric_sphere_backscatter({.ka = ka, .refractive_index = index}));
}

}  // namespace specula
