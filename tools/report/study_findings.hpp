#pragma once

#include <optional>
#include <vector>

#include "tools/report/report_page.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

/// "What agrees, what does not, and why": sentences chosen and filled in by the numbers. Where an
/// interval includes zero no effect is claimed, and a finding whose conditions are missing is left
/// out.
std::vector<Paragraph> study_findings(const StudySummary& study);

std::optional<Paragraph> nominal_finding(const StudySummary& study);
std::optional<Paragraph> session_finding(const StudySummary& study);
std::optional<Paragraph> height_finding(const StudySummary& study);
std::optional<Paragraph> tilt_finding(const StudySummary& study);
std::optional<Paragraph> similar_finding(const StudySummary& study);
std::optional<Paragraph> merged_finding(const StudySummary& study);
std::optional<Paragraph> confidence_finding(const StudySummary& study);
std::optional<Paragraph> monitor_finding(const StudySummary& study);

}  // namespace specula
