#pragma once

#include <atomic>

#include "classifier/feature_table.hpp"
#include "firmware/fw_extract.h"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// What the firmware's extractor makes of every frame of a dataset.
/// Throws InputError where the extractor refuses the frames' shape or the bins.
/// @in  frames_done  counted up, if given
FeatureTable extract_features(const Dataset& dataset, const fw_extract_config& config, int threads,
                              std::atomic<std::size_t>* frames_done = nullptr);

}  // namespace specula
