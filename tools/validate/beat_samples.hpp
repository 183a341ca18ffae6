#pragma once

#include <span>
#include <vector>

#include "materials/electrics.hpp"
#include "scenes/chirp.hpp"

namespace specula {

/// A point that answers with one amplitude at every frequency.
struct PointEcho {
    double range_m;
    double amplitude = 1.0;
};

/// What the mixer delivers for several points, each through the simulator's own path and dechirp
/// with its own residual phase.
std::vector<double> beat_samples(const Chirp& chirp, std::span<const PointEcho> echoes);

/// By how much the beat's phase rises, in radians and any number of turns, when a point at 45 cm
/// moves away by `shift_m`: followed in steps of an eighth of a wavelength.
struct Displacement {
    double frequency_hz;
    double shift_m;
};
double beat_phase_rad(const Displacement& displacement);

}  // namespace specula
