#pragma once

#include <string>

#include "materials/stack.hpp"
#include "scenes/plate.hpp"

namespace specula {

/// The piece of material under the radar.
struct Sample {
    std::string material;
    Plate face;
    double thickness_m = 0.005;        ///< > 0
    double roughness_m = 0.0;          ///< rms height of the face, >= 0
    double permittivity_factor = 1.0;  ///< this piece over the library's material, real part
    double loss_factor = 1.0;          ///< the same for the loss tangent
    std::string backing = "air";       ///< "air", "metal" (perfect), or a material in contact
};

}  // namespace specula
