#pragma once

#include <functional>

#include "materials/library.hpp"
#include "materials/stack.hpp"
#include "scenes/sample.hpp"

namespace specula {

/// What a surface is made of, as layers at a frequency in Hz.
using Reflector = std::function<Stack(double frequency_hz)>;

/// A sample with its materials filled in. `sample.material` and `sample.backing` are names that the
/// library holds; the materials are copied, so the library need not outlive the reflector.
///
/// @in  yaw_rad  of the sample in its plane: with its grain it turns away from the field, which is
///               along y. Where there is no grain it does not matter.
Reflector reflector_of(const Sample& sample, const Library& library, double yaw_rad = 0.0);

}  // namespace specula
