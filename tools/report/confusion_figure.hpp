#pragma once

#include <string>
#include <vector>

#include "classifier/report.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Heat map of a confusion matrix: each row is a true class, shares are of that row, counts beside.
/// @in  name         file stem of the figure
/// @in  class_names  (class), as many as the confusion has classes
Figure confusion_figure(const std::string& name, const ConditionReport& condition,
                        const std::vector<std::string>& class_names);

}  // namespace specula
