#pragma once

#include <string>

#include "tools/report/study_summary.hpp"

namespace specula {

/// The study's numbers for other programs: UTF-8 JSON, keys with units, one object per condition.
std::string results_json(const StudySummary& summary);

}  // namespace specula
