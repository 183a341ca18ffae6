#pragma once

#include <string>
#include <vector>

#include "classifier/assessment.hpp"

namespace specula {

/// Names beside the numbers of an assessment.
struct AssessmentNames {
    const std::vector<std::string>& class_names;
    std::string merged_label{};    ///< "aluminium and iron merged"; empty: none are
    bool has_temperature = false;  ///< whether one was fitted
};

/// Scores, losses, calibration and confusion on standard output; shares in percent, losses in nats.
void print_assessment(const Assessment& assessment, const AssessmentNames& names);

/// How well each monitor tells the data from nominal ones, and how the features drifted.
void print_departure(const Departure& departure);

/// Counts with a row per true class that occurs.
void print_confusion(const Confusion& confusion, const std::vector<std::string>& class_names);

}  // namespace specula
