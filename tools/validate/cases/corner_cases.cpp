#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/far_radar.hpp"
#include "tools/validate/plate_under_radar.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

double checked_edge(const Fields& inp, const std::string& name) {
    const double edge_m = inp.number(name, Range::above(0.0));
    if (edge_m * frequency_of(inp) > 500.0 * speed_of_light_m_s)
        throw NotComputable("sums corners of up to 500 wavelengths");
    return edge_m;
}

Mesh dihedral(double face_m, double length_m) {
    const double top_m = 0.5 * length_m;
    return {{{0, 0, -top_m},
             {0, 0, top_m},
             {face_m, 0, -top_m},
             {face_m, 0, top_m},
             {0, face_m, -top_m},
             {0, face_m, top_m}},
            {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}}};
}

Mesh trihedral(double leg_m) {
    return {{{0, 0, 0}, {leg_m, 0, 0}, {0, leg_m, 0}, {0, 0, leg_m}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
}

/// Cross-section of the waves that met so many faces.
double bounced_m2(const FarRadar& radar, const Mesh& corner, int n_bounces) {
    return radar.cross_section_m2(Target({mesh_body(corner, true, 0.0)}),
                                  {.n_bounces = n_bounces, .these_only = true});
}

double angle_of(const Fields& inp, const std::string& name) {
    constexpr Range inside{.min = 0.0, .max = 90.0, .min_excluded = true, .max_excluded = true};
    return inp.number(name, inside) * pi / 180.0;
}

}  // namespace

std::vector<Quantity> dihedral_point(const CasePoint& point) {
    const double frequency_hz = frequency_of(point.inp);
    const double face_m = checked_edge(point.inp, "face_a_m");
    const double length_m = checked_edge(point.inp, "length_b_m");
    const double angle_rad = angle_of(point.inp, "angle_from_face1_deg");
    const FarWave wave{{std::cos(angle_rad), std::sin(angle_rad), 0.0}, Vector3::UnitZ()};
    const double sigma_m2 = bounced_m2(monostatic(wave, frequency_hz, face_m + length_m),
                                       dihedral(face_m, length_m), 2);
    Comparison compare(point);
    compare.power({"double_bounce_sigma_m2", "dbsm"}, {sigma_m2}, "db");
    return compare.finish();
}

std::vector<Quantity> trihedral_point(const CasePoint& point) {
    const double frequency_hz = frequency_of(point.inp);
    const double leg_m = checked_edge(point.inp, "leg_a_m");
    const SphericalDirection direction{angle_of(point.inp, "theta_deg"),
                                       angle_of(point.inp, "phi_deg")};
    const FarWave wave{direction.outward(), direction.along_phi()};
    const double sigma_m2 = bounced_m2(monostatic(wave, frequency_hz, leg_m), trihedral(leg_m), 3);
    // sigma = 4 pi A^2 / lambda^2: the aperture is off by half the decibels.
    const double aperture_m2 = speed_of_light_m_s / frequency_hz * std::sqrt(sigma_m2 / (4.0 * pi));
    Comparison compare(point);
    compare.power({"sigma_m2", "dbsm"}, {sigma_m2}, "db");
    if (compare.wants("A_eff_m2")) {
        const double allowed = point.tolerance.number("db", Range::at_least(0.0));
        compare.within("A_eff_m2", aperture_m2,
                       {(std::pow(10.0, allowed / 20.0) - 1.0) *
                            point.expect.number("A_eff_m2", Range::above(0.0)),
                        "m^2"});
    }
    return compare.finish();
}

namespace {

/// Two walls that meet in the z axis, and a radar at (x, y, 0) that hears itself.
class InfiniteCorner {
  public:
    explicit InfiniteCorner(const Fields& inp) : frequency_hz_(frequency_of(inp)) {
        const auto xy_m = inp.numbers("radar_xy_m", Range::above(0.0));
        if (xy_m.size() != 2)
            inp.fail("radar_xy_m", "not two numbers", "give [x, y], both above 0, in metres");
        position_m_ = {xy_m[0], xy_m[1], 0.0};
        reach_m_ = std::max(
            {rim_distance_m(xy_m[0]), rim_distance_m(xy_m[1]), rim_distance_m(position_m_.norm())});
        if ((reach_m_ + position_m_.maxCoeff()) * frequency_hz_ > 900.0 * speed_of_light_m_s)
            throw NotComputable("sums corners out to 900 wavelengths");
    }

    /// What a wall alone sends back, and what the corner does.
    Complex wall_x0() const { return transfer({wall(Vector3::UnitY(), -reach_m_)}); }
    Complex wall_y0() const { return transfer({wall(Vector3::UnitX(), -reach_m_)}); }
    Complex corner() const {
        return transfer({wall(Vector3::UnitY(), 0.0), wall(Vector3::UnitX(), 0.0)});
    }

  private:
    /// How far from the foot of a wall its rims must lie for the four of them to add no more than
    /// `ripple` to what it mirrors. One straight rim at W = beta H adds, by stationary phase,
    /// H^2 sqrt(pi R / k) / (2 pi W R^2) < sqrt(pi / (k H beta^5)) / (2 pi).
    double rim_distance_m(double height_m) const {
        constexpr double ripple = 0.005;  // 0.04 dB
        const double k = two_pi * frequency_hz_ / speed_of_light_m_s;
        const double share = 4.0 / (two_pi * ripple);
        return height_m * std::max(1.0, std::pow(pi * share * share / (k * height_m), 0.2));
    }

    /// A wall through the z axis, along x or y from `begin_m` beside the radar's foot, or from 0.
    Body wall(const Vector3& along, double begin_m) const {
        const double foot_m = along.dot(position_m_);
        const double first_m = begin_m < 0.0 ? foot_m + begin_m : 0.0, last_m = foot_m + reach_m_;
        Placement placement;
        placement.rotation.col(0) = along;
        placement.rotation.col(1) = Vector3::UnitZ();
        placement.rotation.col(2) = along.cross(Vector3::UnitZ());
        placement.shift_m = 0.5 * (first_m + last_m) * along;
        return plate_body({.size_x_m = last_m - first_m, .size_y_m = 2.0 * reach_m_}, placement,
                          true, 0.0);
    }

    Complex transfer(std::vector<Body> walls) const {
        Rotation frame;  // polarised along the edge
        frame.col(1) = Vector3::UnitZ();
        frame.col(2) = position_m_.normalized();
        frame.col(0) = frame.col(1).cross(frame.col(2));
        const PlacedAntenna radar{position_m_, frame, IsotropicPattern{}};
        const std::vector<Reflector> mirrors(walls.size(), perfect_reflector());
        const Scatter scatter =
            trace(Target(std::move(walls)), {radar, {radar}},
                  {.highest_hz = frequency_hz_, .accuracy_db = 0.01, .max_bounces = 2});
        return direct_sum(scatter, 0, mirrors, frequency_hz_);
    }

    double frequency_hz_;
    Vector3 position_m_;
    double reach_m_;
};

void check_corner(const Fields& inp) {
    inp.describe({"walls"});
    if (inp.has("antenna") && lower_case(inp.text("antenna")).rfind("iso", 0) != 0)
        throw NotComputable("knows the corner with isotropic antennas only");
    if (inp.has("polarisation") && lower_case(inp.text("polarisation")).rfind("z", 0) != 0)
        throw NotComputable("knows the corner with fields along its edge only");
}

}  // namespace

std::vector<Quantity> corner_images_point(const CasePoint& point) {
    check_corner(point.inp);
    const InfiniteCorner walls(point.inp);
    Comparison compare(point);
    const Complex x0 = walls.wall_x0(), y0 = walls.wall_y0(), total = walls.corner();
    compare.channel("wall_x0.", x0);
    compare.channel("wall_y0.", y0);
    compare.channel("total.", total);
    // The edge, where either wall ends, diffracts in single and in double bounces; together they
    // cancel, as the images say. So the double bounce is what the corner adds to its two walls.
    compare.channel("double_bounce.", total - x0 - y0);
    return compare.finish();
}

}  // namespace specula
