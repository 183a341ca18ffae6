#pragma once

#include "scenes/vector3.hpp"

namespace specula {

/// A surface point between an antenna that sends and one that receives.
struct Bounce {
    Vector3 to_point;  ///< unit, from the TX to the point
    Vector3 to_rx;     ///< unit, from the point to the RX
    Vector3 normal;    ///< unit, on the side of the antennas
    Vector3 tx_field;  ///< field pattern of the TX along to_point
    Vector3 rx_field;  ///< field pattern of the RX along -to_rx
};

/// What the RX picks up per unit of surface currents, split by what multiplies it.
struct BounceWeights {
    double incident = 0.0;  ///< 1
    double te = 0.0;        ///< r_TE
    double tm = 0.0;        ///< r_TM
};

/// Physical optics: the surface carries the currents J = n x (Hi + Hr), M = -n x (Ei + Er) of an
/// infinite plane in its tangent; their radiation towards the RX, per area, without the factor
/// -j/(8 pi) exp(-jk(r1 + r2)) / (r1 r2).
/// @eq   PHYSICS.md#physical-optics
/// Limit: terms of order 1/(k r)^2 are dropped (0.1 % at 45 cm); edges carry no currents of their
/// own.
BounceWeights bounce_weights(const Bounce& bounce);

}  // namespace specula
