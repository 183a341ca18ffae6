#pragma once

#include "materials/electrics.hpp"

namespace specula {

/// How far apart two values are; each is 0 or more.

double absolute_error(Complex computed, Complex expected);

/// Over the expected value; over 1 where 0 is expected.
double relative_error(Complex computed, Complex expected);

/// Between two levels in dB. Levels below `floor_db` are rounding noise, all alike.
double level_error_db(double computed_db, double expected_db, double floor_db = -400.0);

/// Between the magnitudes of two amplitudes.
double amplitude_error_db(Complex computed, Complex expected);

/// The short way round between two angles in degrees, in [0, 180].
double phase_error_deg(double computed_deg, double expected_deg);

double phase_deg(Complex value);  ///< in (-180, 180]
double level_db(Complex amplitude);
double power_db(double ratio);

}  // namespace specula
