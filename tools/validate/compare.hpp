#pragma once

#include "materials/electrics.hpp"

namespace specula {

/// What was found, and what it should be.
struct ComplexPair {
    Complex computed;
    Complex expected;
};
struct NumberPair {
    double computed;
    double expected;
};

/// How far apart they are, 0 or more.

double absolute_error(const ComplexPair& pair);

/// Over the expected value; over 1 where 0 is expected.
double relative_error(const ComplexPair& pair);

/// Between two levels in dB. Levels below `floor_db` are rounding noise, all alike.
double level_error_db(const NumberPair& levels_db, double floor_db = -400.0);

/// Between the magnitudes of two amplitudes.
double amplitude_error_db(const ComplexPair& pair);

/// The short way round between two angles, of which `turn` makes a full circle.
double wrapped_error(const NumberPair& angles, double turn);

double phase_deg(Complex value);  ///< in (-180, 180]
double amplitude_db(Complex amplitude);
double power_db(double ratio);

}  // namespace specula
