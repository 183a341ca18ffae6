#pragma once

#include "scenes/scene.hpp"
#include "sim/channel/reflector.hpp"
#include "sim/trace/target.hpp"

namespace specula {

/// What each body of a scene is made of: the sample first, then the objects in their order.
std::vector<Reflector> reflectors_of(const Scene& scene, const Library& materials);

/// The bodies in the same order, ready for rays.
Target target_of(const Scene& scene, std::span<const Reflector> reflectors);

/// Does nothing worth counting come through? As the file says; where it says nothing, a plate with
/// air behind it that lets more than a millionth of the power through, head-on at the middle of the
/// band, is a sheet, and everything else is opaque.
bool is_opaque(const Sample& matter, const Reflector& reflector, double frequency_hz);

}  // namespace specula
