#pragma once

#include "classifier/feature_table.hpp"

namespace specula {

/// Throws InputError `what: problem; remedy` for rows that nothing can be learnt from: fewer than
/// two, features that are not finite, a single class, or not one feature that varies.
/// @in  rows  labels < class_names.size()
void check_training_rows(const FeatureTable& rows);

/// Throws InputError naming the first example and feature that is not finite.
void check_finite(const FeatureTable& rows);

}  // namespace specula
