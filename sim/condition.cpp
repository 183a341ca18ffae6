#include "sim/condition.hpp"

#include "scenes/scene.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {


}  // namespace

Pose Condition::pose(int session) const {
    const int geometry = session / sessions;
    const auto n_tilts = static_cast<int>(tilts_rad.size());
    Pose pose;
    pose.height_m = heights_m[static_cast<std::size_t>(geometry / n_tilts)];
    pose.pivot_m = pivot_m;
    Pose::Tilt& tilt = tilts_sensor ? pose.sensor : pose.sample;
    (elevation ? tilt.about_x_rad : tilt.about_y_rad) =
        tilts_rad[static_cast<std::size_t>(geometry % n_tilts)];
    return pose;
}

Condition read_condition(Section section, const Radar& radar, double nominal_height_m, int number) {
    Condition condition;
    condition.number = number;
    condition.name = section.text("name");
    condition.title = section.text("title");
    condition.heights_m = {nominal_height_m};
    if (section.has_quantity("height", Unit::length))
        condition.heights_m =
            section.quantities("height", Unit::length, 0, Range::inside(0.0, 100.0));
    for (const double height_m : condition.heights_m) {
        const std::string blind = blind_reason(radar, height_m);
        if (!blind.empty())
            section.fail_quantity("height", Unit::length, format("{:.4g} m {}", height_m, blind),
                                  "choose other heights or another radar");
    }
    if (section.has_quantity("tilt", Unit::angle))
        condition.tilts_rad =
            section.quantities("tilt", Unit::angle, 0, Range::between(-steepest_tilt_rad, steepest_tilt_rad));
    condition.tilts_sensor = section.choice("tilted", {"sensor", "sample"}, "sensor") == "sensor";
    condition.elevation =
        section.choice("tilt_plane", {"azimuth", "elevation"}, "azimuth") == "elevation";
    if (section.has_quantity("pivot", Unit::length)) {
        if (condition.tilts_sensor)
            section.fail_quantity("pivot", Unit::length,
                                  "a tilted sensor turns about its own phase centre",
                                  "remove it, or write tilted = \"sample\"");
        const auto p = section.quantities("pivot", Unit::length, 3, Range::between(-10.0, 10.0));
        condition.pivot_m = {p[0], p[1], p[2]};
    }
    condition.new_samples = section.choice("samples", {"known", "new"}, "known") == "new";
    condition.sessions = section.count("sessions", Range::between(1, Condition::most_sessions));
    condition.frames = section.count("frames", Range::between(1, Condition::most_frames));
    if (condition.sessions_per_class() > Condition::most_sessions)
        section.fail("sessions",
                     format("times the heights and tilts makes {} sessions per class",
                            condition.sessions_per_class()),
                     format("keep them to {}", Condition::most_sessions));
    return condition;
}

}  // namespace specula
