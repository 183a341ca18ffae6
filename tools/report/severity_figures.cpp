#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/report/curve_figure.hpp"
#include "tools/report/forest_figure.hpp"
#include "tools/report/heat_figure.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/result_figures.hpp"

namespace specula {
namespace {

std::string offset_text(double height_m) {
    return height_m == 0.0 ? "0" : format("{:+g} mm", 1e3 * height_m);
}

std::string tilt_text(double tilt_rad) {
    return format("{:.0f}\u00b0", tilt_rad * 180.0 / pi);
}

std::string world_text(const SeverityGrid& grid) {
    return format("{} {}", grid.n_worlds, grid.n_worlds == 1 ? "world" : "worlds");
}

/// Room for a marker at either end.
std::array<double, 2> padded(double low, double high) {
    const double margin = 0.03 * (high - low);
    return {low - margin, high + margin};
}

/// Where the second classifier, good under other geometry, is worse under another receiver.
std::string receiver_losses(const SeverityGrid& grid) {
    if (grid.classifiers.size() < 2) return {};
    std::size_t n = 0, n_below = 0, n_snr = 0, n_snr_below = 0;
    for (const SeverityCell& cell : grid.cells) {
        if (cell.receiver.empty()) continue;
        const bool below = cell.all[1] < cell.all[0];
        const bool is_snr = cell.receiver.starts_with("snr");
        ++n;
        n_below += below;
        n_snr += is_snr;
        n_snr_below += is_snr && below;
    }
    if (n == 0) return {};
    std::string text =
        format(" With all classes apart, \u201c{}\u201d scores below \u201c{}\u201d in {} of these {} "
               "cells",
               grid.classifiers[1], grid.classifiers[0], n_below, n);
    if (n_snr > 0)
        text += n_snr_below == n_snr ? ", at every ratio of signal to noise among them"
                                     : format(", at {} of {} ratios of signal to noise among them",
                                              n_snr_below, n_snr);
    return text + ".";
}

StudyFigure severity_map(const SeverityGrid& grid) {
    HeatContent content{.title = "Severity grid: height and tilt of the sensor",
                        .second_line = "macro-F1 (%), all classes, mean over worlds",
                        .column_title = "tilt of the sensor",
                        .rows = {},
                        .columns = {},
                        .emphasised = {},
                        .panels = {}};
    for (const double offset : grid.height_offsets_m) content.rows.push_back(offset_text(offset));
    for (const double tilt : grid.tilts_rad) content.columns.push_back(tilt_text(tilt));
    for (std::size_t i = 0; i < grid.classifiers.size(); ++i) {
        HeatPanel panel{grid.classifiers[i], {}};
        for (std::size_t row = 0; row < grid.height_offsets_m.size(); ++row) {
            std::vector<std::optional<double>> shares;
            for (std::size_t column = 0; column < grid.tilts_rad.size(); ++column)
                shares.emplace_back(grid.cells[row * grid.tilts_rad.size() + column].all[i]);
            panel.shares.push_back(shares);
        }
        content.panels.push_back(panel);
    }
    return {.figure = heat_figure("severity", content),
            .caption =
                format("Severity over height (rows) and tilt (columns): the known samples of the "
                       "first {}, in sessions of their own, one per class and cell; single cells "
                       "scatter accordingly.",
                       world_text(grid)),
            .place = FigurePlace::severity};
}

/// Cells of the geometry without tilt, or without a height offset.
Curve along(const SeverityGrid& grid, std::size_t classifier, bool over_height) {
    Curve curve{.label = grid.classifiers[classifier], .colour = 2 * classifier};
    for (const SeverityCell& cell : grid.cells) {
        if (!cell.receiver.empty()) continue;
        if ((over_height ? cell.tilt_rad : cell.height_offset_m) != 0.0) continue;
        curve.x.push_back(over_height ? 100.0 * cell.height_offset_m : cell.tilt_rad * 180.0 / pi);
        curve.y.push_back(100.0 * cell.intervals[classifier].mean);
        curve.low.push_back(100.0 * cell.intervals[classifier].low);
        curve.high.push_back(100.0 * cell.intervals[classifier].high);
    }
    return curve;
}

StudyFigure severity_curves(const SeverityGrid& grid) {
    CurveContent content{.title = "Along height and along tilt",
                         .second_line = "mean over worlds, band: 95\u00a0% interval over worlds",
                         .y_title = "macro-F1, all classes (%)",
                         .panels = {{.x_title = "height off the nominal one (cm)",
                                     .x_range = padded(100.0 * grid.height_offsets_m.front(),
                                                       100.0 * grid.height_offsets_m.back()),
                                     .curves = {}},
                                    {.x_title = "tilt of the sensor (degrees)",
                                     .x_range = padded(0.0, grid.tilts_rad.back() * 180.0 / pi),
                                     .curves = {}}}};
    for (std::size_t i = 0; i < grid.classifiers.size(); ++i) {
        content.panels[0].curves.push_back(along(grid, i, true));
        content.panels[1].curves.push_back(along(grid, i, false));
    }
    return {.figure = curve_figure("severity_curves", content),
            .caption = format("Macro-F1 along height without tilt, and along tilt at the nominal "
                              "height, {}.",
                              world_text(grid)),
            .place = FigurePlace::severity};
}

StudyFigure receiver_forest(const SeverityGrid& grid) {
    ForestContent content{.title = "Severities of the receiver and the room",
                          .second_line = "mean over worlds with 95\u00a0% interval over worlds",
                          .axis_title = "macro-F1, all classes (%)",
                          .series = grid.classifiers,
                          .rows = {}};
    for (const SeverityCell& cell : grid.cells) {
        if (cell.receiver.empty()) continue;
        ForestRow row{.label = cell.receiver, .values = {}};
        for (const Interval& interval : cell.intervals)
            row.values.emplace_back(in_percent(interval));
        content.rows.push_back(row);
    }
    return {.figure = forest_figure("severity_receiver", content),
            .caption = format("Gain, signal-to-noise ratio and clutter off their nominal values, at "
                              "the nominal geometry, {}.",
                              world_text(grid)) +
                       receiver_losses(grid),
            .place = FigurePlace::severity};
}

}  // namespace

std::vector<StudyFigure> severity_figures(const StudySummary& study) {
    const SeverityGrid& grid = study.results.severity;
    if (grid.cells.empty()) return {};
    std::vector<StudyFigure> figures{severity_map(grid), severity_curves(grid)};
    if (!grid.cells.back().receiver.empty()) figures.push_back(receiver_forest(grid));
    return figures;
}

}  // namespace specula
