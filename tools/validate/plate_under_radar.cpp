#include "tools/validate/plate_under_radar.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/trace/trace.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Ten million quadrature points, a few hundred megabytes.
constexpr double most_wavelengths_across = 1000.0;

/// A position beside the radar's axis.
Vector3 beside_axis(const Fields& inp, const std::string& name) {
    if (!inp.has(name)) return Vector3::Zero();
    const auto xy_m = inp.numbers(name);
    if (xy_m.size() != 2) inp.fail(name, "not two numbers", "give [x, y] in metres");
    return {xy_m[0], xy_m[1], 0.0};
}

Pose::Tilt tilt_of(const Fields& inp) {
    constexpr Range short_of_edge_on{
        .min = -90.0, .max = 90.0, .min_excluded = true, .max_excluded = true};
    const double tilt_rad = inp.number_or("tilt_deg", 0.0, short_of_edge_on) * pi / 180.0;
    if (!inp.has("tilt_axis")) return {.about_y_rad = tilt_rad};
    const std::string text = lower_case(inp.text("tilt_axis"));
    const std::string axis = text.substr(0, text.find(' '));
    if (axis == "x") return {.about_x_rad = tilt_rad};
    if (axis == "y") return {.about_y_rad = tilt_rad};
    throw NotComputable(format("does not know the tilt axis \"{}\"", text));
}

void check_pivot(const Fields& inp) {
    if (!inp.has("pivot")) return;
    const std::string pivot = lower_case(inp.text("pivot"));
    if (pivot != "plate centre" && pivot != "plate center")
        throw NotComputable(format("does not know the pivot \"{}\"", pivot));
}

Pattern pattern_of(const Fields& inp, const std::string& own_name) {
    if (inp.has(own_name)) return antenna_of(inp, own_name);
    if (inp.has("antenna")) return antenna_of(inp, "antenna");
    return IsotropicPattern{};
}

}  // namespace

Scatter PlateUnderRadar::scatter(double highest_hz) const {
    const Target target({plate_body(plate, sample_placement(pose), true, 0.0)});
    const Placement radar = radar_placement(pose);
    const PlacedAntenna tx{radar.point(tx_m), radar.rotation, tx_pattern};
    const PlacedAntenna rx{radar.point(rx_m), radar.rotation, rx_pattern};
    return trace(target, {tx, {rx}},
                 {.highest_hz = highest_hz, .accuracy_db = validation_accuracy_db});
}

PlateUnderRadar PlateUnderRadar::with_swapped_antennas() const {
    PlateUnderRadar swapped = *this;
    std::swap(swapped.tx_pattern, swapped.rx_pattern);
    std::swap(swapped.tx_m, swapped.rx_m);
    return swapped;
}

double PlateUnderRadar::image_db(double frequency_hz) const {
    const Vector3 down(0.0, 0.0, -1.0);
    const double gain = std::sqrt(gain_towards(tx_pattern, down) * gain_towards(rx_pattern, down));
    return amplitude_db(gain * speed_of_light_m_s / frequency_hz / (8.0 * pi * pose.height_m));
}

PlateUnderRadar plate_under_radar(const Fields& inp, double highest_hz) {
    const double side_m = inp.number("L_m", Range::above(0.0));
    if (side_m * highest_hz > most_wavelengths_across * speed_of_light_m_s)
        throw NotComputable("sums plates of up to 1000 wavelengths");
    check_pivot(inp);
    PlateUnderRadar scene;
    scene.plate = {.size_x_m = side_m,
                   .size_y_m = side_m,
                   .bow_m = inp.number_or("sag_at_edge_midpoint_m", 0.0)};
    scene.pose.height_m = inp.number("H_m", Range::above(0.0));
    scene.pose.sample = tilt_of(inp);
    scene.pose.pivot_m = beside_axis(inp, "plate_centre_xy_m");
    scene.pose.offset_x_m = scene.pose.pivot_m.x();
    scene.pose.offset_y_m = scene.pose.pivot_m.y();
    scene.tx_pattern = pattern_of(inp, "ant_tx");
    scene.rx_pattern = pattern_of(inp, "ant_rx");
    scene.tx_m = beside_axis(inp, "tx_xy_m");
    scene.rx_m = beside_axis(inp, "rx_xy_m");
    scene.reflector = perfect_reflector();
    return scene;
}

Reflector perfect_reflector() {
    return [](double frequency_hz) {
        return Stack{.backing = PerfectConductor{}, .frequency_hz = frequency_hz};
    };
}

Reflector slab_reflector(const Fields& inp, const std::string& prefix) {
    const Layer layer{.medium = {.permittivity = inp.permittivity(prefix + "eps")},
                      .thickness_m = inp.number(prefix + "d_m", Range::above(0.0))};
    const std::string behind = prefix + "backing";
    const Backing backing = inp.has(behind) ? backing_of(inp, behind) : Backing{HalfSpace{}};
    return [=](double frequency_hz) {
        return Stack{.layers = {layer}, .backing = backing, .frequency_hz = frequency_hz};
    };
}

}  // namespace specula
