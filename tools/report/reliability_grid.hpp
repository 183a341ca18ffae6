#pragma once

#include <string>
#include <vector>

#include "tools/report/figure.hpp"
#include "tools/report/study_results.hpp"

namespace specula {

struct ReliabilityPanel {
    std::string title{};
    std::vector<ReliabilityPoint> points{};
    double calibration_error = 0.0;  ///< in [0, 1]
};

struct ReliabilityGrid {
    double least_confidence = 0.0;  ///< of the largest probability: one over the classes
    std::vector<ReliabilityPanel> panels{};
};

/// Small multiples: share of right answers over confidence with its interval, and how the frames
/// spread over the bins.
/// @in  content  at least one panel
Figure reliability_grid(const std::string& name, const ReliabilityGrid& content);

}  // namespace specula
