#include "sim/trace/physical_optics.hpp"

#include "sim/trace/polarisation.hpp"

namespace specula {

namespace {

/// What the RX picks up of the currents that a plane wave along `direction` drives in the surface,
/// as a vector that the wave's field is projected on: the bracket of PHYSICS.md#physical-optics
/// with its cross products multiplied out.
Vector3 reception_of(const Bounce& bounce, const Vector3& direction) {
    const Vector3 &n = bounce.normal, &o = bounce.to_rx, &rx = bounce.rx_field;
    const double along_rx = rx.dot(o), steep = n.dot(direction);
    return (rx.dot(direction) - along_rx * o.dot(direction)) * n +
           (along_rx * steep + rx.dot(n)) * o - (steep + o.dot(n)) * rx;
}

}  // namespace

BounceWeights bounce_weights(const Bounce& bounce) {
    const Vector3& in = bounce.to_point;
    const Vector3& n = bounce.normal;
    const Vector3 s = across_plane_of_incidence(in, n);
    const Vector3 out = mirrored_direction(in, n);
    const Vector3 p_in = s.cross(in), p_out = s.cross(out);
    const Vector3 reflected = reception_of(bounce, out);
    return {.incident = bounce.tx_field.dot(reception_of(bounce, in)),
            .te = bounce.tx_field.dot(s) * s.dot(reflected),
            .tm = bounce.tx_field.dot(p_in) * p_out.dot(reflected)};
}

}  // namespace specula
