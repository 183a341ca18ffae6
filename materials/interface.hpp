#pragma once

#include "materials/electrics.hpp"

namespace specula {

/// Field reflection coefficients of the two polarisations, E field, in the sign of ITU-R P.2040:
/// at normal incidence te = -tm; a perfect conductor has te = -1, tm = +1.
struct Reflection {
    Complex te{0.0, 0.0};
    Complex tm{0.0, 0.0};
};

/// A perfect electric conductor.
inline constexpr Reflection pec_reflection{{-1.0, 0.0}, {1.0, 0.0}};

/// Normalised longitudinal wave number q = sqrt(eps mu - sin^2), Im(q) <= 0: exp(-jkqz) decays
/// into a lossy medium. `sin_squared` in [0, 1] is of the angle in air.
Complex longitudinal_wavenumber(const Electrics& medium, double sin_squared);

/// A medium, and the longitudinal wave number in it at one angle.
struct MediumWave {
    const Electrics* medium;
    Complex q;
};
MediumWave wave_in(const Electrics& medium, double sin_squared);

/// Fresnel coefficients at the flat face from medium `from` to medium `to`.
/// Equal media have no face between them: both coefficients are 0, at grazing incidence too.
/// @eq PHYSICS.md#fresnel; ITU-R P.2040-3 equations (31a), (31b), with permeability
Reflection fresnel(const MediumWave& from, const MediumWave& to);
Reflection fresnel(const Electrics& from, const Electrics& to, double sin_squared);

}  // namespace specula
