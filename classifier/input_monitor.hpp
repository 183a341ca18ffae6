#pragma once

#include <optional>

#include "classifier/feature_table.hpp"
#include "classifier/model.hpp"

namespace specula {

/// Class means and their common covariance, in double, rounded once; the limit of what is familiar
/// is the 99th percentile of the rows' own distances.
///
/// A hundred-thousandth of the mean variance is added to the diagonal, so that a constant feature
/// does not make the covariance singular.
/// @in   rows  at least two; features finite
/// @out  nothing for more features than the firmware takes, or for rows without any spread
/// @eq   K. Lee et al., NeurIPS 2018, equation (1), on the inputs
std::optional<InputMonitor> fit_input_monitor(const FeatureTable& rows);

}  // namespace specula
