#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "classifier/report.hpp"
#include "tools/report/figure.hpp"

namespace specula {

struct ForestRow {
    std::string label{};
    std::vector<std::optional<Interval>> values{};  ///< (series), in the unit of the axis
    std::optional<std::array<double, 2>> band{};    ///< where the value is expected
    bool emphasised = false;
};

struct ForestContent {
    std::string title{}, second_line{};
    std::string axis_title{};
    std::array<double, 2> range{0.0, 100.0};
    std::vector<std::string> series{};
    std::vector<ForestRow> rows{};
    std::optional<double> reference{};  ///< a line from top to bottom
    std::string band_label{};           ///< for the legend; empty: there are no bands
    /// What the table of the data is in: 0.01 of the axis' percents, or the axis' own unit.
    std::string csv_unit = "share";
    double csv_scale = 0.01;
};

/// Intervals beside the names of what they belong to, one lane per series; grey bars are the bands.
Figure forest_figure(const std::string& name, const ForestContent& content);

}  // namespace specula
