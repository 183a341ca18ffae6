#pragma once

#include <string>

#include "classifier/report.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Distribution of the largest softmax probability over correctly and over wrongly classified
/// frames. Each of the two adds up to 100 %, so that a rare group stays visible; the legend says
/// how many frames each has. The axis begins at the bin of 1 / classes, below which no maximum
/// lies.
Figure confidence_figure(const std::string& name, const ConditionReport& condition);

}  // namespace specula
