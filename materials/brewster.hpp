#pragma once

#include "materials/interface.hpp"

namespace specula {

/// Where a half-space reflects least of the TM polarisation.
struct BrewsterAngle {
    double incidence_rad;  ///< in air, from the normal
    double reflection_tm;  ///< |r_TM| there: 0 without losses
};

/// @eq    PHYSICS.md#brewster
/// Limit: non-magnetic media; a permeability may move the zero to TE.
BrewsterAngle brewster_angle(const Electrics& medium);

}  // namespace specula
