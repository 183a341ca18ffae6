#pragma once

#include "tools/firmware/latency_study.hpp"
#include "tools/report/figure.hpp"

namespace specula {

/// Macro-F1 of nominal frames over estimated time, one series per arithmetic; 20 us is marked.
Figure latency_figure(const LatencyStudy& study);

}  // namespace specula
