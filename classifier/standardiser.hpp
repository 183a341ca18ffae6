#pragma once

#include <vector>

#include "classifier/feature_table.hpp"

namespace specula {

/// What makes features comparable: x' = (x - mean) * scale, in float as the firmware does it.
struct Standardiser {
    std::vector<float> mean;   ///< (feature), unit of the feature
    std::vector<float> scale;  ///< (feature), one over that unit, >= 0
};

/// Zero mean and unit variance over these rows: the training rows, never those it is judged by.
///
/// A feature whose standard deviation is within 1e-6 of its mean (16 roundings of a float) is
/// constant: it teaches nothing here, so its scale is 0 and no shift can wake it later.
/// @in  rows  at least 1, finite
Standardiser fit_standardiser(const FeatureTable& rows);

}  // namespace specula
