#pragma once

#include <string>

#include "tools/bench/bench.hpp"

namespace specula {

/// What was measured as tables for people: rates with their limits, stages, growth, threads.
std::string bench_text(const BenchReport& report);

/// The same for programs, with the machine it ran on.
std::string bench_json(const BenchReport& report, const BenchPlan& plan);

}  // namespace specula
