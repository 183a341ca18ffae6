#include "sim/geometry_law.hpp"

#include "scenes/scene.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double least_draw = 0x1p-33;  ///< the outermost numbers that a stream gives

struct Axis {
    const char* key;
    Unit unit;
    Range range;
    double& (*of)(Pose&);
};

const std::array<Axis, GeometryLaw::n_axes>& axes() {
    static const Range tilt = Range::between(-steepest_tilt_rad, steepest_tilt_rad);
    static const Range offset_m = Range::between(-10.0, 10.0);
    static const std::array<Axis, GeometryLaw::n_axes> all{{
        {"height", Unit::length, Range::inside(0.0, 100.0),
         [](Pose& pose) -> double& { return pose.height_m; }},
        {"sensor_tilt_x", Unit::angle, tilt,
         [](Pose& pose) -> double& { return pose.sensor.about_x_rad; }},
        {"sensor_tilt_y", Unit::angle, tilt,
         [](Pose& pose) -> double& { return pose.sensor.about_y_rad; }},
        {"sample_tilt_x", Unit::angle, tilt,
         [](Pose& pose) -> double& { return pose.sample.about_x_rad; }},
        {"sample_tilt_y", Unit::angle, tilt,
         [](Pose& pose) -> double& { return pose.sample.about_y_rad; }},
        {"offset_x", Unit::length, offset_m, [](Pose& pose) -> double& { return pose.offset_x_m; }},
        {"offset_y", Unit::length, offset_m, [](Pose& pose) -> double& { return pose.offset_y_m; }},
        {"yaw", Unit::angle, Range::between(-pi, pi),
         [](Pose& pose) -> double& { return pose.yaw_rad; }},
    }};
    return all;
}

std::size_t values_in(const SampledLaw& law) {
    return std::get<Distribution::Choice>(law.law.law()).values.size();
}

/// Height and tilt may be drawn from laws without bounds: what they can give must be possible.
void check_draws(const Section& section, const Axis& axis, const SampledLaw& law,
                 const Radar& radar) {
    for (const double u : {least_draw, 0.5, 1.0 - least_draw}) {
        const double value = law.law.quantile(u);
        if (!axis.range.holds(value))
            section.fail_quantity(
                axis.key, axis.unit,
                format("may be drawn as {:.4g} (SI), which is out of range", value),
                "choose a law that stays inside, such as uniform");
        const std::string blind = axis.of == axes()[0].of ? blind_reason(radar, value) : "";
        if (!blind.empty())
            section.fail_quantity(axis.key, axis.unit,
                                  format("may be drawn as {:.4g} m, which {}", value, blind),
                                  "choose another law or another radar");
    }
}

}  // namespace

std::array<std::string_view, GeometryLaw::n_axes> geometry_axis_names() {
    std::array<std::string_view, GeometryLaw::n_axes> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = axes()[i].key;
    return names;
}

Pose GeometryLaw::pose(const SpreadItem& item) const {
    Pose pose;
    pose.pivot_m = pivot_m;
    std::size_t steps = item.index;  // through the grids, the first axis fastest
    for (std::size_t i = 0; i < n_axes; ++i) {
        const SampledLaw& law = laws[i];
        double& value = axes()[i].of(pose);
        if (law.sampling == Sampling::grid) {
            const auto& values = std::get<Distribution::Choice>(law.law.law()).values;
            value = values[steps % values_in(law)];
            steps /= values_in(law);
            continue;
        }
        value = law.law.quantile(spread_uniform(
            item, {.name = axes()[i].key, .dimension = static_cast<int>(i)}, law.sampling));
    }
    return pose;
}

GeometryLaw read_geometry(Section section, const Radar& radar, double nominal_height_m) {
    GeometryLaw geometry;
    for (std::size_t i = 0; i < GeometryLaw::n_axes; ++i) {
        const Axis& axis = axes()[i];
        geometry.laws[i] =
            section.sampled_law(axis.key, axis.unit, axis.range, i == 0 ? nominal_height_m : 0.0);
        check_draws(section, axis, geometry.laws[i], radar);
    }
    if (section.has_quantity("pivot", Unit::length)) {
        const auto p = section.quantities("pivot", Unit::length, 3, Range::between(-10.0, 10.0));
        geometry.pivot_m = {p[0], p[1], p[2]};
    }
    section.finish();
    return geometry;
}

}  // namespace specula
