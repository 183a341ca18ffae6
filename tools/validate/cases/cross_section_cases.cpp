#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/far_radar.hpp"
#include "tools/validate/plate_under_radar.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Beyond this the quadrature does not fit the machine.
constexpr double most_wavelengths = 1000.0;

double checked_size(double size_m, double frequency_hz) {
    if (size_m * frequency_hz > most_wavelengths * speed_of_light_m_s)
        throw NotComputable("sums targets of up to 1000 wavelengths");
    return size_m;
}

/// `theta_deg` off the normal of a face, short of edge-on.
double aspect_of(const Fields& inp) {
    return inp.number("theta_deg",
                      {.min = -90.0, .max = 90.0, .min_excluded = true, .max_excluded = true}) *
           pi / 180.0;
}

FarRadar radar_at(const SphericalDirection& direction, double frequency_hz, double size_m) {
    return monostatic({direction.outward(), direction.along_phi()}, frequency_hz, size_m);
}

/// Level that the main lobe's plate pattern reaches 0.1 degrees beside the null that is nearest to
/// an aspect, if that null is nearer than this; no floor else. The null's own depth is nobody's to
/// judge, and the case says so.
double floor_at_null_db(double side_m, double wavelength_m, double aspect_rad) {
    constexpr double beside_rad = 0.1 * pi / 180.0;
    const auto level_db = [&](double rad) {
        const double u = two_pi / wavelength_m * side_m * std::sin(rad);
        const double lobe = u == 0.0 ? 1.0 : std::sin(u) / u;
        return power_db(4.0 * pi *
                        std::pow(side_m * side_m / wavelength_m * std::cos(rad) * lobe, 2));
    };
    const double order = std::round(2.0 * side_m * std::sin(aspect_rad) / wavelength_m);
    const double sine = order * wavelength_m / (2.0 * side_m);
    if (order == 0.0 || std::abs(sine) >= 1.0) return -400.0;
    const double null_rad = std::asin(sine);
    if (std::abs(aspect_rad - null_rad) >= beside_rad) return -400.0;
    return std::max(level_db(null_rad - beside_rad), level_db(null_rad + beside_rad));
}

}  // namespace

std::vector<Quantity> plate_cross_section_point(const CasePoint& point) {
    const double frequency_hz = frequency_of(point.inp);
    const double side_m = checked_size(point.inp.number("L_m", Range::above(0.0)), frequency_hz);
    const double aspect_rad = aspect_of(point.inp);
    if (point.inp.has("plane") && lower_case(point.inp.text("plane")) != "principal")
        throw NotComputable("knows the principal plane only");
    const double sigma_m2 =
        radar_at({aspect_rad, 0.0}, frequency_hz, side_m)
            .cross_section_m2(
                Target({plate_body({.size_x_m = side_m, .size_y_m = side_m}, {}, true, 0.0)}), {});
    const double floor_db = floor_at_null_db(side_m, speed_of_light_m_s / frequency_hz, aspect_rad);
    Comparison compare(point);
    compare.power({"sigma_m2", "sigma_dbsm"}, {sigma_m2, floor_db}, "db");
    return compare.finish();
}

std::vector<Quantity> disc_or_cylinder_point(const CasePoint& point) {
    const double frequency_hz = frequency_of(point.inp);
    Comparison compare(point);
    const auto compare_power = [&](double sigma_m2, const std::string& key) {
        compare.power({"sigma_m2", "dbsm"}, {sigma_m2}, key);
    };
    if (point.inp.has("cylinder_radius_m")) {
        const double radius_m = point.inp.number("cylinder_radius_m", Range::above(0.0));
        const double length_m = point.inp.number("length_m", Range::above(0.0));
        const double size_m = checked_size(2.0 * radius_m + length_m, frequency_hz);
        if (point.inp.has("aspect") && lower_case(point.inp.text("aspect")) != "broadside")
            throw NotComputable("knows the cylinder's broadside only");
        const FarWave across{Vector3::UnitX(), Vector3::UnitZ()};
        compare_power(monostatic(across, frequency_hz, size_m)
                          .cross_section_m2(
                              Target({smooth_body(CylinderSurface{radius_m, length_m, {}})}), {}),
                      "db_cylinder");
        return compare.finish();
    }
    const double radius_m = point.inp.number("disc_radius_m", Range::above(0.0));
    const double size_m = checked_size(2.0 * radius_m, frequency_hz);
    compare_power(radar_at({aspect_of(point.inp), 0.0}, frequency_hz, size_m)
                      .cross_section_m2(Target({smooth_body(DiscSurface{radius_m, {}})}), {}),
                  "db");
    return compare.finish();
}

namespace {

/// `<name>` = [theta, phi] in degrees.
SphericalDirection direction_of(const Fields& inp, const std::string& name) {
    const auto angles = inp.numbers(name);
    if (angles.size() != 2) inp.fail(name, "not two angles", "give [theta, phi] in degrees");
    return {angles[0] * pi / 180.0, angles[1] * pi / 180.0};
}

FarWave wave_of(const SphericalDirection& direction, char polarisation) {
    return {direction.outward(),
            polarisation == 't' ? direction.along_theta() : direction.along_phi()};
}

Mesh triangle_of(const Fields& inp) {
    const auto rows = inp.rows("vertices_m");
    if (rows.size() != 3) inp.fail("vertices_m", "not three corners", "give three of [x, y, z]");
    Mesh mesh{.vertices_m = {}, .triangles = {{0, 1, 2}}};
    for (const auto& row : rows) {
        if (row.size() != 3) inp.fail("vertices_m", "not three corners", "give three of [x, y, z]");
        mesh.vertices_m.emplace_back(row[0], row[1], row[2]);
    }
    return mesh;
}

}  // namespace

std::vector<Quantity> triangle_point(const CasePoint& point) {
    const double frequency_hz = frequency_of(point.inp);
    const Mesh triangle = triangle_of(point.inp);
    const std::string polarisations = lower_case(point.inp.text("pol"));
    if (polarisations.size() != 2 || polarisations.find_first_not_of("tp") != std::string::npos)
        throw NotComputable("does not know the polarisations \"" + polarisations + "\"");
    double size_m = 0.0;
    for (const Vector3& vertex : triangle.vertices_m) size_m = std::max(size_m, vertex.norm());
    const Body body = mesh_body(triangle, true, 0.0);
    if (body.surfaces.empty())
        point.inp.fail("vertices_m", "no area between them", "give three corners of a triangle");
    const FarRadar radar{
        .frequency_hz = frequency_hz,
        .target_size_m = checked_size(size_m, frequency_hz),
        .sent = wave_of(direction_of(point.inp, "inc_from_theta_phi_deg"), polarisations[0]),
        .received = wave_of(direction_of(point.inp, "scat_to_theta_phi_deg"), polarisations[1])};
    const Complex amplitude_m = radar.amplitude_m(Target({body}), {});
    Comparison compare(point);
    compare.relative("F_complex_m", amplitude_m, "rel");
    compare.relative("sigma_m2", 4.0 * pi * std::norm(amplitude_m), "rel");
    return compare.finish();
}

}  // namespace specula
