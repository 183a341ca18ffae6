#pragma once

#include "materials/interface.hpp"

namespace specula {

/// The face between two media, and the rms of its heights.
struct RoughFace {
    const Electrics& above;
    const Electrics& below;
    double roughness_m;
};

/// The factors by which a rough face lowers its coherent field coefficients, each in (0, 1].
struct FaceLoss {
    double reflect_above = 1.0;  ///< reflection seen from above
    double reflect_below = 1.0;
    double transmit_twice = 1.0;  ///< down and up again: the square of one pass
};

/// Gaussian heights average the phase of what a face reflects and lets through.
/// @in   sin_squared  of the angle in air, in [0, 1]
/// @eq   PHYSICS.md#coherent-roughness; Ament, Proc. IRE 41 (1953) 142
/// Limit: slopes gentle, no shadows; the diffuse part is not in here.
FaceLoss face_loss(const RoughFace& face, double wavenumber_rad_m, double sin_squared);
/// @in  ks  wave number in air times rms height, radian
FaceLoss face_loss(const MediumWave& above, const MediumWave& below, double ks);

/// A rough face under a wave in air.
struct RoughIncidence {
    double frequency_hz;
    double roughness_m;    ///< rms height
    double cos_incidence;  ///< in (0, 1]
};

/// Phase difference between the top and the foot of a step of one rms height.
/// @out  radian; Rayleigh calls a face smooth below pi/2
/// @eq   PHYSICS.md#rayleigh
double rayleigh_parameter(const RoughIncidence& incidence);

}  // namespace specula
