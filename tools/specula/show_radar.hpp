#pragma once

#include "scenes/radar.hpp"

namespace specula {

/// Explains a radar: chirp, frame, antennas, link budget of a mirror at a height, leakage.
void show_radar(const Radar& radar, double height_m);

}  // namespace specula
