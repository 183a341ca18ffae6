#include <cmath>

#include "scenes/vector3.hpp"
#include "tests/tools/validate/made_up_case.hpp"
#include "tools/validate/formulas/mie_sphere.hpp"

// Discs, spheres, corners and triangles that no reference file has, against closed forms.

namespace specula {
namespace {

using Json = nlohmann::json;
using C = std::complex<double>;

constexpr double light = 299792458.0;

bool fails(const Json& document) {
    return validated(document).verdict() == Verdict::fail;
}

TEST_CASE("another disc on the axis gives its radial integral", "[validate][N02]") {
    const double f_hz = 77e9, k = two_pi * f_hz / light, radius = 0.033, height = 0.37;
    const double rim = std::hypot(height, radius);
    constexpr int n = 4000;
    C sum = 0.0;  // -(j/2) G H Int exp(-2jkr) / r^2 dr, by Simpson's rule
    for (int i = 0; i <= 2 * n; ++i) {
        const double r = height + (rim - height) * i / (2 * n);
        sum += std::polar((i == 0 || i == 2 * n ? 1.0 : i % 2 ? 4.0 : 2.0) / (r * r), -2.0 * k * r);
    }
    const C h = C(0.0, -0.5) * 2.5 * height * sum * (rim - height) / (6.0 * n);
    const Json inp{{"radius_m", radius}, {"H_m", height}, {"f_hz", f_hz}, {"G", 2.5}};
    const Json tolerance{{"db", 0.001}, {"phase_deg", 0.01}};
    check_passes(case_of("N02_disc_onaxis", inp, {{"h", pair_of(h)}}, tolerance));
    CHECK(fails(case_of("N02_disc_onaxis", inp, {{"h", pair_of(1.001 * h)}}, tolerance)));
}

Json corner_expectation(double x, double y, double f_hz) {
    const double k = two_pi * f_hz / light, wavelength = light / f_hz;
    const auto image = [&](double distance, double sign) {
        return std::polar(sign * wavelength / (8.0 * pi * distance), -2.0 * k * distance);
    };
    const C x0 = image(x, -1.0), y0 = image(y, -1.0), both = image(std::hypot(x, y), 1.0);
    return {{"wall_x0", {{"h", pair_of(x0)}}},
            {"wall_y0", {{"h", pair_of(y0)}}},
            {"double_bounce", {{"h", pair_of(both)}}},
            {"total", {{"h", pair_of(x0 + y0 + both)}}}};
}

TEST_CASE("another radar in the corner sees three images", "[validate][N07]") {
    const Json inp{{"radar_xy_m", {0.21, 0.13}}, {"polarisation", "z"}, {"f_hz", 24e9}};
    const Json tolerance{{"db", 0.15}, {"phase_deg", 3.0}};
    Json expect = corner_expectation(0.21, 0.13, 24e9);
    expect["total"]["abs_db"] = -50.0;  // wrong, and the only one that may fail
    const CaseVerdict verdict = validated(case_of("N07_dihedral_image", inp, expect, tolerance));
    REQUIRE(verdict.points.front().quantities.size() == 9);
    for (const Quantity& quantity : verdict.points.front().quantities) {
        INFO(quantity.name << " off by " << quantity.error);
        CHECK(quantity.passes() == (quantity.name != "total.abs_db"));
    }
}

TEST_CASE("another metal sphere is a mirror that spreads; a dielectric one is only shown",
          "[validate][N09]") {
    Json inp{{"sphere", "PEC"},
             {"radius_m", 0.06},
             {"distance_to_surface_m", 0.5},
             {"f_hz", 76e9},
             {"G", 3.0}};
    const double optics = 3.0 * light / 76e9 / (8.0 * pi * 0.5) * 0.06 / 0.56;
    const Json expect{{"abs_db", 20.0 * std::log10(optics)},
                      {"go_abs_db", 20.0 * std::log10(optics)},
                      {"exact_over_go_db", 0.0}};
    const Json tolerance{{"db_pec", 0.1},  // ka = 96: optics is good to 1/ka
                         {"phase_deg_pec", 4.0},
                         {"note", "dielectric rows are informative"}};
    check_passes(case_of("N09_sphere_nearfield", inp, expect, tolerance));
    CHECK(fails(case_of("N09_sphere_nearfield", inp, {{"abs_db", -60.0}}, tolerance)));
    inp["sphere"] = "dielectric";
    inp["eps"] = {4.0, 0.0};
    check_passes(case_of("N09_sphere_nearfield", inp, {{"abs_db", -60.0}}, tolerance));
}

TEST_CASE("a traced mesh of a sphere is within half a decibel of the Mie series",
          "[validate][R01]") {
    for (const double ka : {20.0, 50.0}) {
        const Json document =
            case_of("R01_mie_pec", {{"ka", ka}},
                    {{"sigma_over_pi_a2", conducting_sphere_backscatter(ka)}}, {{"rel", 1e-9}});
        const CaseVerdict verdict = validated(document);
        CHECK(verdict.verdict() == Verdict::pass);
        const double traced_db = std::get<double>(computed(verdict, "traced_mesh_db"));
        CHECK(std::abs(traced_db - 10.0 * std::log10(conducting_sphere_backscatter(ka))) < 0.5);
        CHECK(traced_db != 10.0 * std::log10(conducting_sphere_backscatter(ka)));
    }
}

TEST_CASE("another plate far away has its pattern of sines, whatever its nulls' depth",
          "[validate][R03]") {
    const double f_hz = 24e9, wavelength = light / f_hz, side = 0.11;
    const auto sigma = [&](double deg) {
        const double u = two_pi / wavelength * side * std::sin(deg * pi / 180.0);
        return 4.0 * pi *
               std::pow(side * side / wavelength * std::cos(deg * pi / 180.0) * std::sin(u) / u, 2);
    };
    const auto document = [&](double deg, double sigma_m2) {
        return case_of("R03_plate_po",
                       {{"L_m", side}, {"f_hz", f_hz}, {"theta_deg", deg}, {"plane", "principal"}},
                       {{"sigma_m2", sigma_m2}, {"sigma_dbsm", 10.0 * std::log10(sigma_m2)}},
                       {{"db", 0.001}});
    };
    for (const double deg : {-31.0, 1.3, 12.3, 55.0}) check_passes(document(deg, sigma(deg)));
    CHECK(fails(document(12.3, 1.01 * sigma(12.3))));
    const double null_deg = std::asin(wavelength / (2.0 * side)) * 180.0 / pi;
    check_passes(document(null_deg + 0.001, 1e-20));
    CHECK(fails(document(null_deg + 0.2, 1e-20)));
}

TEST_CASE("another triangle scatters to any side as its sum of phases says", "[validate][R04]") {
    const double k = two_pi * 24e9 / light;
    const Vector3 a(0.002, -0.004, 0.003), b(0.021, 0.001, 0.001), c(-0.001, 0.017, 0.006);
    const auto out = [](double theta, double phi) {
        return Vector3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                       std::cos(theta));
    };
    const double t1 = 0.4, p1 = 0.7, t2 = 0.6, p2 = 5.1;
    const Vector3 from = out(t1, p1), to = out(t2, p2);
    const Vector3 sent = out(t1 + pi / 2.0, p1),
                  received(-std::sin(p2), std::cos(p2), 0.0);  // "tp"
    constexpr int n = 300;
    C sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n - i; ++j) {
            const auto at = [&](double s, double t) -> Vector3 {
                return a + (b - a) * (s / n) + (c - a) * (t / n);
            };
            sum += std::polar(1.0, k * (from + to).dot(at(i + 1.0 / 3.0, j + 1.0 / 3.0)));
            if (j < n - i - 1)
                sum += std::polar(1.0, k * (from + to).dot(at(i + 2.0 / 3.0, j + 2.0 / 3.0)));
        }
    }
    const Vector3 twice_area = (b - a).cross(c - a);
    const Vector3 current = 2.0 * twice_area.normalized().cross((-from).cross(sent));
    const C amplitude =
        C(0.0, -k / (4.0 * pi)) * current.dot(received) * sum * (0.5 * twice_area.norm() / (n * n));
    const double degree = 180.0 / pi;
    const Json inp{
        {"vertices_m", {{0.002, -0.004, 0.003}, {0.021, 0.001, 0.001}, {-0.001, 0.017, 0.006}}},
        {"f_hz", 24e9},
        {"pol", "tp"},
        {"inc_from_theta_phi_deg", {t1 * degree, p1 * degree}},
        {"scat_to_theta_phi_deg", {t2 * degree, p2 * degree}}};
    const auto document = [&](C f) {
        return case_of("R04_triangle_po", inp,
                       {{"F_complex_m", pair_of(f)}, {"sigma_m2", 4.0 * pi * std::norm(f)}},
                       {{"rel", 1e-4}});
    };
    check_passes(document(amplitude));
    CHECK(fails(document(amplitude * std::polar(1.0, 2e-4))));
}

TEST_CASE("other corners return what their apertures say", "[validate][R05][R06]") {
    const double f_hz = 77e9, wavelength = light / f_hz;
    for (const double deg : {20.0, 63.0}) {
        const double s = std::sin(deg * pi / 180.0), c = std::cos(deg * pi / 180.0);
        const double aperture = 2.0 * 0.06 * 0.04 * std::min(s, c);
        const double sigma = 4.0 * pi * std::pow(aperture / wavelength, 2);
        const Json inp{{"face_a_m", 0.06},
                       {"length_b_m", 0.04},
                       {"f_hz", f_hz},
                       {"angle_from_face1_deg", deg}};
        check_passes(case_of("R05_dihedral", inp, {{"double_bounce_sigma_m2", sigma}},
                             {{"db", 0.1}}));  // shadows are cut to a tenth of a wavelength
        if (deg > 45.0)
            CHECK(fails(case_of("R05_dihedral", inp, {{"dbsm", 10.0 * std::log10(sigma) + 0.2}},
                                {{"db", 0.1}})));
    }
    const double sigma = 4.0 * pi * std::pow(0.04, 4) / (3.0 * wavelength * wavelength);
    const Json inp{{"leg_a_m", 0.04},
                   {"f_hz", f_hz},
                   {"phi_deg", 45.0},
                   {"theta_deg", std::acos(1.0 / std::sqrt(3.0)) * 180.0 / pi}};
    check_passes(case_of("R06_trihedral", inp,
                         {{"sigma_m2", sigma}, {"A_eff_m2", 0.04 * 0.04 / std::sqrt(3.0)}},
                         {{"db", 0.1}}));
    CHECK(fails(case_of("R06_trihedral", inp, {{"sigma_m2", 1.1 * sigma}}, {{"db", 0.1}})));
}

TEST_CASE("other discs and cylinders far away have their closed forms", "[validate][R07]") {
    const double f_hz = 36e9, wavelength = light / f_hz, k = two_pi / wavelength;
    for (const double deg : {0.5, 7.0, 40.0}) {
        const double radius = 0.05, u = 2.0 * k * radius * std::sin(deg * pi / 180.0);
        const double sigma =
            4.0 * pi * std::pow(pi * radius * radius / wavelength, 2) *
            std::pow(std::cos(deg * pi / 180.0) * 2.0 * std::cyl_bessel_j(1, u) / u, 2);
        const Json inp{{"disc_radius_m", radius}, {"f_hz", f_hz}, {"theta_deg", deg}};
        check_passes(case_of("R07_disc_cyl", inp, {{"sigma_m2", sigma}}, {{"db", 0.001}}));
        if (deg < 1.0)
            CHECK(
                fails(case_of("R07_disc_cyl", inp, {{"sigma_m2", 1.01 * sigma}}, {{"db", 0.001}})));
    }
    const Json inp{
        {"cylinder_radius_m", 0.04}, {"length_m", 0.07}, {"f_hz", f_hz}, {"aspect", "broadside"}};
    const double sigma = k * 0.04 * 0.07 * 0.07;
    check_passes(case_of("R07_disc_cyl", inp, {{"sigma_m2", sigma}}, {{"db_cylinder", 0.1}}));
    CHECK(
        fails(case_of("R07_disc_cyl", inp, {{"sigma_m2", 1.05 * sigma}}, {{"db_cylinder", 0.1}})));
}

}  // namespace
}  // namespace specula
