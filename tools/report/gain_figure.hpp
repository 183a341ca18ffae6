#pragma once

#include <optional>
#include <string>
#include <vector>

#include "classifier/report.hpp"
#include "tools/report/figure.hpp"

namespace specula {

struct GainRow {
    std::string label{};
    bool emphasised = false;
    std::vector<std::vector<Interval>> values{};  ///< (panel, series), differences of shares
};

struct GainContent {
    std::string title{}, second_line{};
    std::vector<std::string> series{};  ///< one or two
    std::vector<std::string> panels{};  ///< conditions, from left to right
    std::vector<GainRow> rows{};
};

/// Paired differences with their intervals: a row per remedy, a narrow panel per condition, each on
/// an axis of its own in points, with a line at zero.
Figure gain_figure(const std::string& name, const GainContent& content);

}  // namespace specula
