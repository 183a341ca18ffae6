#pragma once

#include "tools/report/report_page.hpp"
#include "tools/validate/verdict.hpp"

namespace specula {

/// The page of a validation: the table, then one figure per group of cases. Draws with gnuplot.
ReportPage validation_page(const Validation& validation);

}  // namespace specula
