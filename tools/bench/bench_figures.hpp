#pragma once

#include <vector>

#include "tools/bench/bench.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Will there be a plot of what is measured?
bool draws_figures(const BenchPlan& plan);

/// What was measured as plots: the stages of a session, and how costs grow. Those parts only that
/// the report has.
std::vector<Figure> bench_figures(const BenchReport& report);

}  // namespace specula
