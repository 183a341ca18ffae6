#pragma once

#include "classifier/descriptor.hpp"

namespace specula {

/// Range bins by the firmware's own extractor and fw_normalise, as fw_classify runs them; then over
/// the root of their sum of squares, if asked.
/// @in   descriptor  range_bins
/// @out  (frame, n_bins); labels and groups are set
/// Throws InputError where the frames cannot be described so.
FeatureTable normalised_bins(const Dataset& dataset, const Descriptor& descriptor, int threads,
                             std::atomic<std::size_t>* frames_done = nullptr);

}  // namespace specula
