#pragma once

#include <nlohmann/json.hpp>

#include "tools/report/study_results.hpp"

namespace specula {

/// {"mean", "low_95", "high_95"}: worlds, and within them sessions, are resampled.
nlohmann::ordered_json interval_json(const Interval& interval);

/// {"mean", "low_95_over_worlds", "high_95_over_worlds"}: worlds alone are resampled.
nlohmann::ordered_json world_interval_json(const Interval& interval);

/// What a study found beyond its conditions, one key per part; parts that were not asked for are
/// left out.
void add_results(const StudyResults& results, nlohmann::ordered_json& json);

}  // namespace specula
