#pragma once

#include "sim/channel/path.hpp"
#include "sim/population.hpp"

namespace specula {

/// Adds the room: points in front of the radar, each in a direction of its own within 60 degrees
/// of the boresight, with a complex Gaussian amplitude of the law's mean power.
/// @in mirror_transfer  |h| of a mirror at the nominal height
void add_clutter(Channel& channel, const FrequencyComb& comb, const ClutterLaw& law,
                 const Radar& radar, double mirror_transfer, Stream& stream);

/// |h| of an infinite mirror at a height: lambda G / (4 pi 2H), G along the boresight.
/// @eq PHYSICS.md#image-source
double mirror_transfer(const Radar& radar, double height_m);

}  // namespace specula
