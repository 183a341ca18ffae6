#pragma once

#include "scenes/plate.hpp"
#include "scenes/pose.hpp"

namespace specula {

/// Where a smooth sample would mirror the radar back to itself, if it were large enough: what
/// decides whether a tilt, or a height, changes the echo.
struct MirrorFoot {
    double x_m = 0.0;  ///< from the centre of the face, along its own axes
    double y_m = 0.0;
    double range_m = 0.0;           ///< from the phase centre to the foot
    double fresnel_radius_m = 0.0;  ///< around it lies what the echo is made of
    double critical_size_m = 0.0;   ///< a face of this edge just holds the foot
    double divergence_db = 0.0;     ///< by the bow: the echo over that of a flat face

    /// How much of the Fresnel zone's radius lies between the foot and the nearest rim of a face;
    /// below 0 the foot has left it, beyond 1 the rim hardly matters.
    double margin(const Plate& face) const;
};

/// The foot of the perpendicular from the phase centre to the plane of the face.
/// @in   frequency_hz  > 0
/// @eq   PHYSICS.md#mirror-foot, #fresnel-zone, #bow-divergence
/// Limit: the divergence is that of rays, for foci farther than the radar; the rim's waves, which
/// add up to 2 dB on a 30 cm face, are not in it.
MirrorFoot mirror_foot(const Pose& pose, const Plate& face, double frequency_hz);

}  // namespace specula
