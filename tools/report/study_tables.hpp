#pragma once

#include "tools/report/report_page.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

/// Macro-F1 of every condition beside the paper's.
ReportTable macro_f1_table(const StudySummary& study);

/// What could warn of a shift: drift of the inputs, confidence, and how far the latter is from the
/// share of correct frames.
ReportTable monitor_table(const StudySummary& study);

}  // namespace specula
