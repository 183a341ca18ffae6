#pragma once

#include <string>

#include "classifier/class_probabilities.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Confidence against the share that is right.
struct ReliabilityCurves {
    Reliability raw;
    Reliability scaled;        ///< after temperature scaling
    double temperature = 1.0;  ///< 1: nothing was fitted, and only the raw curve is drawn
};

/// Reliability diagram: share right over mean confidence of every bin, and how many are in it.
/// @in  name   file stem of the figure
/// @in  title  of the condition
Figure reliability_figure(const std::string& name, const std::string& title,
                          const ReliabilityCurves& curves);

}  // namespace specula
