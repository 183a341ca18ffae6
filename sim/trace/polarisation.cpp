#include "sim/trace/polarisation.hpp"

namespace specula {

Vector3 across_plane_of_incidence(const Vector3& direction, const Vector3& normal) {
    const Vector3 across = direction.cross(normal);
    const double sine = across.norm();
    return sine > 1e-12 ? Vector3(across / sine) : normal.unitOrthogonal();
}

FieldParts after_reflection(const FieldParts& parts, const Vector3& direction,
                            const Vector3& normal) {
    const Vector3 s = across_plane_of_incidence(direction, normal);
    const Vector3 p_in = s.cross(direction);
    const Vector3 p_out = s.cross(mirrored_direction(direction, normal));
    FieldParts split;
    for (const Vector3& field : parts) {
        split.push_back(field.dot(s) * s);
        split.push_back(field.dot(p_in) * p_out);
    }
    return split;
}

FieldParts after_transmission(const FieldParts& parts, const Vector3& direction,
                              const Vector3& normal) {
    const Vector3 s = across_plane_of_incidence(direction, normal);
    const Vector3 p = s.cross(direction);
    FieldParts split;
    for (const Vector3& field : parts) {
        split.push_back(field.dot(s) * s);
        split.push_back(field.dot(p) * p);
    }
    return split;
}

}  // namespace specula
