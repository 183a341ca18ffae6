#pragma once

#include "scenes/vector3.hpp"

namespace specula {

/// A point of the free edge of a half-plane, and the axes of the half-plane there.
struct EdgeFrame {
    Vector3 inward;  ///< unit, in the half-plane, at right angles to the edge
    Vector3 normal;  ///< unit, on the side of the antennas
    Vector3 along() const { return inward.cross(normal); }
};

/// Unit directions of the wave that strikes an edge and of the one that leaves it.
struct EdgeBounce {
    Vector3 arriving;
    Vector3 leaving;
};

/// Fringe current of a perfectly conducting half-plane per unit field, times jk: what the currents
/// of the exact solution add to those of physical optics, summed from the edge inwards along the
/// diffracted ray that grazes the half-plane.
///
/// eta0 times the current, a vector in the half-plane. Zero where the wave runs within a degree of
/// the edge: there a half-plane is no model of an edge of finite length.
/// @in   field  of the striking wave, at right angles to `arriving`
/// @eq   PHYSICS.md#edge-currents; Michaeli, IEEE Trans. Antennas Propag. 34 (1986) 912
/// Limit: one edge at a time; the opposite edge, corners and the thickness of a plate do not count.
Vector3 fringe_current(const EdgeFrame& edge, const EdgeBounce& bounce, const Vector3& field);

}  // namespace specula
