#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/far_radar.hpp"
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

void compare_sphere(Comparison& compare, const CasePoint& point, double ka,
                    double sigma_over_disc) {
    compare.relative("sigma_over_pi_a2", sigma_over_disc, "rel");
    if (compare.wants("sigma_m2")) {
        const double radius_m = ka * speed_of_light_m_s / (two_pi * frequency_of(point.inp));
        compare.relative("sigma_m2", sigma_over_disc * pi * radius_m * radius_m, "rel");
    }
}

/// Cross-section over that of its disc of a sphere of triangles, through the simulator.
///
/// Legs D of the triangles hold 2k D^2 / (4a) below a tenth of a radian, so that the facets are
/// the sphere but for 0.01 dB. The radar looks at it off the poles of the mesh.
double traced_mesh_over_disc(double ka) {
    constexpr double radius_m = 1.0;
    const double leg_m = radius_m * std::sqrt(0.2 / ka);
    const auto n = static_cast<std::uint32_t>(std::ceil(pi * radius_m / leg_m));
    const Mesh mesh = triangulate(SphereSurface{radius_m, {}}, Cells{n, 2 * n});
    const SphericalDirection direction{1.1, 0.4};
    const FarRadar radar =
        monostatic({direction.outward(), direction.along_theta()},
                   ka * speed_of_light_m_s / (two_pi * radius_m), 2.0 * radius_m);
    return radar.cross_section_m2(Target({mesh_body(mesh, true, 0.0)}), {}) /
           (pi * radius_m * radius_m);
}

/// Physical optics knows no waves that creep around: their share is 0.2 dB at ka = 20, and falls.
constexpr Range traced_sizes{.min = 20.0, .max = 400.0};
constexpr double traced_tolerance_db = 0.5;

}  // namespace

std::vector<Quantity> conducting_sphere_point(const CasePoint& point) {
    const double ka = circumference_of(point.inp);
    const double series = conducting_sphere_backscatter(ka);
    Comparison compare(point);
    compare_sphere(compare, point, ka, series);
    if (ka >= traced_sizes.min && ka <= traced_sizes.max) {
        const double traced = traced_mesh_over_disc(ka);
        compare.additional({"traced_mesh_db", power_db(traced), power_db(series),
                            level_error_db({power_db(traced), power_db(series)}),
                            traced_tolerance_db, "dB"});
    }
    return compare.finish();
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
    Comparison compare(point);
    compare_sphere(compare, point, ka,
                   dielectric_sphere_backscatter({.ka = ka, .refractive_index = index}));
    return compare.finish();
}

}  // namespace specula
