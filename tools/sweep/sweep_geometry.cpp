#include "tools/sweep/sweep_geometry.hpp"

namespace specula {

Plate SweepGeometry::face(const Plate& of_scene) const {
    return {.size_x_m = size_x_m, .size_y_m = size_y_m, .bow_m = of_scene.bow_m};
}

Pose SweepGeometry::pose(const Pose& of_scene) const {
    Pose pose = of_scene;
    pose.height_m = height_m;
    pose.sensor = pose.sample = {};
    Pose::Tilt& tilt = sensor ? pose.sensor : pose.sample;
    (elevation ? tilt.about_x_rad : tilt.about_y_rad) = tilt_rad;
    return pose;
}

SweepGeometry geometry_at(const SweepPlan& plan, const SweepIndex& at) {
    const auto& [size_x_m, size_y_m] = plan.sizes_m[at.size];
    const Tilting& tilting = plan.tiltings[at.tilting];
    const double tilt_rad = plan.tilts_rad[at.tilt];
    return {.size_x_m = size_x_m,
            .size_y_m = size_y_m,
            .height_m = plan.heights_m[at.height],
            .tilt_rad = tilt_rad,
            .sensor = tilt_rad != 0.0 && tilting.sensor,
            .elevation = tilt_rad != 0.0 && tilting.elevation};
}

SweepGeometry untilted(SweepGeometry geometry) {
    geometry.tilt_rad = 0.0;
    geometry.sensor = geometry.elevation = false;
    return geometry;
}

SweepGeometry nominal(SweepGeometry geometry, const SweepPlan& plan) {
    geometry.height_m = plan.scene.pose.height_m;
    return untilted(geometry);
}

std::map<SweepGeometry, std::size_t> numbered_geometries(const SweepPlan& plan) {
    std::map<SweepGeometry, std::size_t> numbers;
    for_each_geometry(plan, [&](const SweepIndex& at) {
        const SweepGeometry geometry = geometry_at(plan, at);
        for (const SweepGeometry& needed : {geometry, untilted(geometry), nominal(geometry, plan)})
            numbers.emplace(needed, numbers.size());
    });
    return numbers;
}

}  // namespace specula
