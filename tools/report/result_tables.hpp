#pragma once

#include <vector>

#include "tools/report/report_page.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

/// Tables of what a study found beyond its conditions; none where a part is missing.

std::vector<ReportTable> part_tables(const StudySummary& study);         ///< single heights, tilts
std::vector<ReportTable> attribution_tables(const StudySummary& study);  ///< paper's percentiles
std::vector<ReportTable> remedy_tables(const StudySummary& study);       ///< scores and costs
std::vector<ReportTable> severity_tables(const StudySummary& study);     ///< headline
std::vector<ReportTable> check_tables(const StudySummary& study);        ///< with verdicts
std::vector<ReportTable> confidence_tables(const StudySummary& study);   ///< confidence, fallback

/// The conditions in which a rung does worst, classes apart and merged.
struct WorstScores {
    Interval all, merged;
};
/// @in  domains  at least one
WorstScores worst_of(const std::vector<DomainScore>& domains);

/// What was found, in plain words and full sentences, for the first page. Where an interval
/// includes zero no effect is claimed.
std::vector<Paragraph> plain_words(const StudySummary& study);

/// How the one free scalar was set, or why it was not.
Paragraph calibration_words(const CalibrationOutcome& outcome);

}  // namespace specula
