#pragma once

#include <string>

#include "classifier/risk_coverage.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Share of wrong answers over the share of frames answered, the surest first.
/// @in  name   file stem of the figure
/// @in  title  of the condition
Figure risk_coverage_figure(const std::string& name, const std::string& title,
                            const RiskCoverage& curve);

}  // namespace specula
