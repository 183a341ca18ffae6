#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/plate_under_radar.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// A plate at one frequency, traced.
class TracedPlate {
  public:
    explicit TracedPlate(const Fields& inp)
        : frequency_hz_(frequency_of(inp)),
          scene_(plate_under_radar(inp, frequency_hz_)),
          scatter_(scene_.scatter(frequency_hz_)) {}

    double frequency_hz() const { return frequency_hz_; }
    const PlateUnderRadar& scene() const { return scene_; }
    double image_db() const { return scene_.image_db(frequency_hz_); }
    Complex transfer(const Reflector& reflector) const {
        return direct_sum(scatter_, 0, {&reflector, 1}, frequency_hz_);
    }
    Complex transfer() const { return transfer(scene_.reflector); }

  private:
    double frequency_hz_;
    PlateUnderRadar scene_;
    Scatter scatter_;
};

/// Expected level over the image's, by whatever the point gives of it.
double expected_over_image_db(const CasePoint& point, double image_db) {
    if (point.expect.has("rel_image_db")) return point.expect.number("rel_image_db");
    if (point.expect.has("abs_db")) return point.expect.number("abs_db") - image_db;
    if (point.expect.has("h")) return amplitude_db(point.expect.complex("h")) - image_db;
    return 0.0;
}

/// Cases may allow more where little comes back.
std::string level_key(const CasePoint& point, double image_db) {
    constexpr const char* of_low_levels = "db_below_minus20dB_rel_image";
    const bool low = expected_over_image_db(point, image_db) < -20.0;
    return low && point.tolerance.has(of_low_levels) ? of_low_levels : "db";
}

/// h, and its level over that of an infinite mirror.
void compare_echo(Comparison& compare, const CasePoint& point, const TracedPlate& plate,
                  Complex h) {
    const std::string key = level_key(point, plate.image_db());
    compare.channel("", h, {.level = key});
    compare.level("rel_image_db", amplitude_db(h) - plate.image_db(), key);
}

}  // namespace

std::vector<Quantity> plate_point(const CasePoint& point) {
    const TracedPlate plate(point.inp);
    Comparison compare(point);
    compare_echo(compare, point, plate, plate.transfer());
    return compare.finish();
}

std::vector<Quantity> dielectric_plate_point(const CasePoint& point) {
    point.inp.describe({"material"});
    const Reflector slab = slab_reflector(point.inp);
    const TracedPlate plate(point.inp);
    const Complex h = plate.transfer(slab);
    Comparison compare(point);
    compare_echo(compare, point, plate, h);
    compare.level("rel_pec_plate_db", amplitude_db(h / plate.transfer()), "db");
    compare.level("slab_r0_db", amplitude_db(stack_reflection(slab(plate.frequency_hz()), 1.0).te),
                  "db");
    return compare.finish();
}

std::vector<Quantity> near_to_far_point(const CasePoint& point) {
    const TracedPlate plate(point.inp);
    const Complex h = plate.transfer();
    // sigma = 4 pi A^2 / lambda^2 in the radar equation: |h| = G A / (4 pi H^2).
    const double wavelength_m = speed_of_light_m_s / plate.frequency_hz();
    const double height_m = plate.scene().pose.height_m, side_m = plate.scene().plate.size_x_m;
    const double far_db =
        plate.image_db() + amplitude_db(2.0 * side_m * side_m / (wavelength_m * height_m));
    Comparison compare(point);
    compare_echo(compare, point, plate, h);
    compare.level("far_field_radar_eq_db", far_db, "db");
    compare.level("near_over_far_db", amplitude_db(h) - far_db, "db");
    return compare.finish();
}

std::vector<Quantity> bowed_plate_point(const CasePoint& point) {
    const std::string surface = point.inp.has("surface") ? point.inp.text("surface") : "";
    if (!surface.empty() && surface != "z=-sag*(x^2+y^2)/(L/2)^2")
        throw NotComputable("does not know the surface \"" + surface + "\"");
    const TracedPlate plate(point.inp);
    const double half_m = 0.5 * plate.scene().plate.size_x_m;
    const double curvature_per_m = 2.0 * plate.scene().plate.bow_m / (half_m * half_m);
    Comparison compare(point);
    compare_echo(compare, point, plate, plate.transfer());
    // A mirror of radius Rc spreads what it returns by Rc / (Rc + H).
    compare.level("go_divergence_db",
                  -amplitude_db(1.0 + curvature_per_m * plate.scene().pose.height_m), "db");
    return compare.finish();
}

std::vector<Quantity> reciprocity_point(const CasePoint& point) {
    point.inp.describe({"swapped"});
    const TracedPlate plate(point.inp);
    const Complex h = plate.transfer();
    Comparison compare(point);
    compare_echo(compare, point, plate, h);
    const PlateUnderRadar swapped = plate.scene().with_swapped_antennas();
    const Complex back = direct_sum(swapped.scatter(plate.frequency_hz()), 0,
                                    {&swapped.reflector, 1}, plate.frequency_hz());
    compare.additional({"h (TX and RX swapped)", back, h, relative_error({back, h}),
                        point.tolerance.number("self_consistency_rel", Range::at_least(0.0)),
                        "relative"});
    return compare.finish();
}

}  // namespace specula
