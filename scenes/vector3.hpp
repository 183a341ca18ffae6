#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace specula {

/// Points and directions; metres where they are points. x is the azimuth axis of the radar, y its
/// elevation axis, z points from the sample up to the radar.
using Vector3 = Eigen::Vector3d;
using Rotation = Eigen::Matrix3d;

}  // namespace specula
