#pragma once

#include "scenes/scene.hpp"

namespace specula {

/// Refuses a scene in which the sample or an object touches an antenna; adds warnings about what is
/// too near, behind the antennas, out of the chirp's range, or around the radar.
/// @in  geometry  where a mistake of the sample's place is told
/// @in  root      where that of an object is told
void check_places(Section& geometry, Section& root, Scene& scene);

}  // namespace specula
