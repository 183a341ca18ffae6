#pragma once

#include "scenes/scene.hpp"
#include "sim/channel/channel.hpp"

namespace specula {

/// Where a run leaves what physical optics is known to be good for: one line each, with the number
/// that is out and how far full-wave solutions are known to differ there. The scene's own warnings
/// (antennas nearer than 3 cm, short correlation lengths) come from reading it.
/// @eq PHYSICS.md#limits

/// What the scene alone tells: samples and objects of a few wavelengths, dielectrics below 20, and
/// dielectrics whose edge currents were asked for.
std::vector<std::string> optics_limits(const Scene& scene, const Library& materials);

/// What the echo tells: that it is 15 dB or more below an endless sheet of the sample's layers at
/// the sample's height. Nothing of a scene with other objects, whose echoes cannot be told apart.
/// @in  echo  of the scene, no leakage in it
std::vector<std::string> echo_limits(const Scene& scene, const Library& materials,
                                     const Channel& echo);

}  // namespace specula
