#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "scenes/catalogue.hpp"
#include "sim/condition.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

struct StudyRequest {
    std::filesystem::path experiment_file;
    std::filesystem::path out;
    std::optional<std::uint64_t> seed;  ///< instead of the file's
    int threads = 1;
    bool quick = false;   ///< the experiment's small extent
    bool full = false;    ///< its large one
    bool report = true;   ///< else no figures and no page: results alone
    std::string command;  ///< that repeats the study, for its report
    /// See RunSettings; for tests of the order of events.
    std::function<void(const Condition&)> before_recording{};
};

/// Records every condition, trains one classifier per world, judges them, and writes datasets/,
/// models/, firmware/, figures/, calibration.json, results.json, stages.csv and report.html below
/// `out`.
StudySummary run_study(const StudyRequest& request, const Catalogue& catalogue);

}  // namespace specula
