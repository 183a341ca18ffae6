#pragma once

#include "scenes/vector3.hpp"

namespace specula {

/// A rectangular face, flat or bowed to a paraboloid, in its own frame: centre at the origin,
/// normal +z at the centre.
///
/// Height of the face: z = -bow ((2x/size_x)^2 + (2y/size_y)^2); a positive bow is a dome, its
/// edge midpoints `bow` below the centre.
struct Plate {
    double size_x_m = 0.3;  ///< > 0
    double size_y_m = 0.3;  ///< > 0
    double bow_m = 0.0;

    double height_m(double x_m, double y_m) const;
    /// Normal times the area element per dx dy: (-dz/dx, -dz/dy, 1).
    Vector3 area_normal(double x_m, double y_m) const;
};

}  // namespace specula
