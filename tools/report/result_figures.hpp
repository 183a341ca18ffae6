#pragma once

#include <vector>

#include "tools/report/study_figures.hpp"

namespace specula {

/// Figures of what a study found beyond its conditions; parts that it lacks have none.

/// Waterfall, sensitivity to assumptions, prior-predictive scatter.
std::vector<StudyFigure> attribution_figures(const StudySummary& study);
/// The ladder as a matrix of rungs and conditions, and paired gains.
std::vector<StudyFigure> remedy_figures(const StudySummary& study);
/// The grid as a heat map, along height and tilt, and the receiver's severities.
std::vector<StudyFigure> severity_figures(const StudySummary& study);
/// Checks with their bands.
std::vector<StudyFigure> check_figures(const StudySummary& study);
/// Detectors, reliability, risk against coverage, drift of the inputs.
std::vector<StudyFigure> monitor_figures(const StudySummary& study);

/// A condition's title, shortened for axes: "Height", "Sensor tilted", ...; its name if unknown.
std::string short_title(const std::string& condition);

/// The interval in percent.
Interval in_percent(const Interval& share);

}  // namespace specula
