#pragma once

#include "scenes/vector3.hpp"

namespace specula {

/// How the radar and the sample lie to each other.
///
/// Untilted, the sample's face is the plane z = 0 and the radar's phase centre stands at
/// (0, 0, height) looking along -z. Angles turn by the right-hand rule, first about x, then about
/// y: `about_y_rad` tilts in the azimuth plane, `about_x_rad` in the elevation plane.
struct Pose {
    struct Tilt {
        double about_x_rad = 0.0;
        double about_y_rad = 0.0;
    };

    double height_m = 0.45;  ///< phase centre above the untilted face, > 0
    Tilt sensor{};           ///< turns the radar about its own phase centre
    Tilt sample{};           ///< turns the sample about `pivot_m`
    Vector3 pivot_m = Vector3::Zero();
    double offset_x_m = 0.0;  ///< centre of the sample beside the radar's axis
    double offset_y_m = 0.0;
    double yaw_rad = 0.0;  ///< turn of the sample in its own plane
};

/// A rigid motion: rotation, then shift.
struct Placement {
    Rotation rotation = Rotation::Identity();
    Vector3 shift_m = Vector3::Zero();

    Vector3 point(const Vector3& p_m) const { return rotation * p_m + shift_m; }
    Vector3 direction(const Vector3& d) const { return rotation * d; }
};

/// From the radar's own frame (phase centre at the origin, boresight -z) to the scene.
Placement radar_placement(const Pose& pose);

/// From the sample's own frame (centre of the face at the origin, normal +z) to the scene.
Placement sample_placement(const Pose& pose);

}  // namespace specula
