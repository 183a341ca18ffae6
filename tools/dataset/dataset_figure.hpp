#pragma once

#include "tools/dataset/dataset_summary.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Small panels: of each class that has frames (at most nine, those with most) the mean profile
/// with a band of one standard deviation and three single frames; then the distributions of height,
/// tilts and SNR, as far as they are known and vary, over all classes.
/// @in  name  of the dataset, for the title
Figure dataset_figure(const std::string& name, const DatasetSummary& summary);

}  // namespace specula
