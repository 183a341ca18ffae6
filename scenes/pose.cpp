#include "scenes/pose.hpp"

namespace specula {

namespace {

Rotation rotation_of(const Pose::Tilt& tilt) {
    return (Eigen::AngleAxisd(tilt.about_y_rad, Vector3::UnitY()) *
            Eigen::AngleAxisd(tilt.about_x_rad, Vector3::UnitX()))
        .toRotationMatrix();
}

}  // namespace

Placement radar_placement(const Pose& pose) {
    return {rotation_of(pose.sensor), {0.0, 0.0, pose.height_m}};
}

Placement sample_placement(const Pose& pose) {
    const Rotation tilt = rotation_of(pose.sample);
    const Rotation yaw = Eigen::AngleAxisd(pose.yaw_rad, Vector3::UnitZ()).toRotationMatrix();
    const Vector3 centre_m(pose.offset_x_m, pose.offset_y_m, 0.0);
    return {tilt * yaw, tilt * (centre_m - pose.pivot_m) + pose.pivot_m};
}

}  // namespace specula
