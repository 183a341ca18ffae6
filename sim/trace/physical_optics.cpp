#include "sim/trace/physical_optics.hpp"

#include "sim/trace/polarisation.hpp"

namespace specula {

namespace {

/// Radiation of the currents that a plane wave `field` along `direction` drives in the surface.
double received(const Bounce& bounce, const Vector3& direction, const Vector3& field) {
    const Vector3 electric = bounce.normal.cross(direction.cross(field));  // eta0 J
    const Vector3 magnetic = -bounce.normal.cross(field);                  // M
    const Vector3 radiated =
        electric - bounce.to_rx * bounce.to_rx.dot(electric) + magnetic.cross(bounce.to_rx);
    return bounce.rx_field.dot(radiated);
}

}  // namespace

BounceWeights bounce_weights(const Bounce& bounce) {
    const Vector3& in = bounce.to_point;
    const Vector3& n = bounce.normal;
    const Vector3 s = across_plane_of_incidence(in, n);
    const Vector3 out = mirrored_direction(in, n);
    const Vector3 p_in = s.cross(in), p_out = s.cross(out);
    return {.incident = received(bounce, in, bounce.tx_field),
            .te = received(bounce, out, bounce.tx_field.dot(s) * s),
            .tm = received(bounce, out, bounce.tx_field.dot(p_in) * p_out)};
}

}  // namespace specula
