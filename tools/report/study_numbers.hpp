#pragma once

#include <optional>
#include <string>

#include "tools/report/study_summary.hpp"

namespace specula {

/// Numbers that follow from the summary. Shares are in [0, 1]; 0 where there is nothing to count.

double accuracy(const Confusion& confusion);
/// Share of the frames that are called `predicted`, whatever they are.
double predicted_share(const Confusion& confusion, std::size_t predicted);
std::size_t most_predicted(const Confusion& confusion);

/// How well classes that count as one when merged are told apart.
struct MergedClasses {
    double share_of_errors;  ///< wrong frames that stay within the merged classes
    double right_within;     ///< of the frames of these classes called one of them, the right ones
    double guessing;         ///< what `right_within` would be by guessing
};
MergedClasses merged_classes(const Confusion& confusion, const std::vector<std::size_t>& merged);

/// Share of the counts above the edge between two bins.
double share_above(const std::array<std::int64_t, ConfidenceHistogram::n_bins>& counts,
                   std::size_t first_bin);

/// How far the inputs of a condition have moved, or nullptr where that was not measured.
const InputDrift* find_drift(const StudySummary& study, std::string_view condition);

/// Where the echo of a flat sample at this height lies, in range bins.
double echo_bin(const RadarFacts& radar, double height_m);

/// "iron and aluminium"
std::string listed(const std::vector<std::string>& items);
/// Names of the merged classes, listed.
std::string merged_names(const StudySummary& study);

/// "under the nominal geometry", "with the sensor tilted", ...; the title in quotation marks for a
/// condition that the report does not know.
std::string where(const StudyCondition& condition);

}  // namespace specula
