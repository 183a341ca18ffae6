#pragma once

#include "classifier/descriptor.hpp"
#include "firmware/fw_relative.h"

namespace specula {

/// What fw_relative is to do, on the host and in a blob.
/// @in   descriptor  peak_shape
fw_relative_config shape_config(const Descriptor& descriptor);

/// What the firmware's fw_relative makes of every frame: amplitude and phase around the strongest
/// echo, relative to it, and its level. relative_profile.hpp has the same idea in double and without
/// interpolation; this is what runs on the chip.
/// @in   descriptor  peak_shape, align and range set; its count of bins is that of the shape
/// @out  (frame, 2 n_bins + 1)
/// Throws InputError where the firmware refuses the frames.
FeatureTable peak_shapes(const Dataset& dataset, const Descriptor& descriptor, int threads);

}  // namespace specula
