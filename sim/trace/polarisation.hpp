#pragma once

#include <vector>

#include "scenes/vector3.hpp"

namespace specula {

/// A field split by what it will be multiplied with: after n events there are 2^n parts, the last
/// event in the lowest bit, TE before TM.
using FieldParts = std::vector<Vector3>;

/// Splits each part at a flat face: TE across the plane of incidence, TM in it.
/// @in  direction, normal  unit; the normal of either side
FieldParts after_reflection(const FieldParts& parts, const Vector3& direction,
                            const Vector3& normal);
FieldParts after_transmission(const FieldParts& parts, const Vector3& direction,
                              const Vector3& normal);

/// A unit direction mirrored at a face.
inline Vector3 mirrored_direction(const Vector3& direction, const Vector3& normal) {
    return direction - 2.0 * direction.dot(normal) * normal;
}

/// The unit vector across the plane of incidence; any in the face at normal incidence, where TE and
/// TM are the same but for their sign.
Vector3 across_plane_of_incidence(const Vector3& direction, const Vector3& normal);

}  // namespace specula
