#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scenes/catalogue.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

struct StudyRequest {
    std::filesystem::path experiment_file;
    std::filesystem::path out;
    std::optional<std::uint64_t> seed;  ///< instead of the file's
    int threads = 1;
    bool quick = false;
    std::string command;  ///< that repeats the study, for its report
};

/// Records every condition, trains one classifier per world, judges them, and writes datasets/,
/// models/, firmware/, figures/, results.json and report.html below `out`.
StudySummary run_study(const StudyRequest& request, const Catalogue& catalogue);

}  // namespace specula
