#pragma once

#include "scenes/antenna.hpp"

namespace specula {

/// Integral of a patch's gain over all directions; 4 pi for a lossless antenna.
double gain_over_sphere(const PatchPattern& patch);

/// A rectangular plate below an antenna, centred and square to it.
struct PlateBelow {
    double size_x_m;
    double size_y_m;
    double height_m;
};

/// Share of the radiated power that falls on the plate: integral of G cos / (4 pi r^2).
double intercepted_share(const Pattern& pattern, const PlateBelow& plate);

/// The same for an isotropic antenna: the solid angle of a rectangle over 4 pi.
double solid_angle_share(const PlateBelow& plate);

}  // namespace specula
