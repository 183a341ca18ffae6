#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/curve_figure.hpp"
#include "tools/report/forest_figure.hpp"
#include "tools/report/heat_figure.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/reliability_grid.hpp"
#include "tools/report/result_figures.hpp"

namespace specula {
namespace {

StudyFigure detector_matrix(const StudyResults& results) {
    HeatContent content{
        .title = "What notices a shift",
        .second_line = "against frames of the nominal geometry recorded anew; 50: chance",
        .column_title = "",
        .rows = {},
        .columns = {},
        .emphasised = {},
        .panels = {{"AUROC (%)", {}}, {"shifted frames that pass at 95\u00a0% (%)", {}}}};
    for (const DetectorScore& score : results.detectors) {
        const bool is_new = content.rows.empty() || content.rows.back() != score.detector;
        if (is_new) {
            content.rows.push_back(score.detector);
            content.panels[0].shares.emplace_back();
            content.panels[1].shares.emplace_back();
        }
        if (content.rows.size() == 1) content.columns.push_back(short_title(score.domain));
        content.panels[0].shares.back().emplace_back(score.auroc.mean);
        content.panels[1].shares.back().emplace_back(score.fpr95.mean);
    }
    for (std::string& row : content.rows) std::ranges::replace(row, '_', ' ');
    return {.figure = heat_figure("detectors", content),
            .caption =
                "Detectors of a shift: area under the ROC curve, and the share of shifted "
                "frames that pass where 95\u00a0% of the familiar ones do. Mahalanobis and "
                "prototypes look at the inputs, the others at the network's answer.",
            .place = FigurePlace::monitors};
}

StudyFigure reliability_figures(const StudySummary& study) {
    ReliabilityGrid content;
    content.least_confidence =
        1.0 / static_cast<double>(std::max<std::size_t>(1, study.class_names.size()));
    for (const ConfidenceQuality& quality : study.results.confidence)
        content.panels.push_back(
            {short_title(quality.domain), quality.reliability, quality.ece});
    return {.figure = reliability_grid("reliability", content),
            .caption =
                "Reliability: how often an answer of a confidence is right, in 15 bins of equal "
                "width, all worlds together, with 95\u00a0% intervals over worlds. Below the dashed "
                "line the network is too sure. Bars: share of the frames in each bin, on the same "
                "axis; a bin without a bar holds a handful of frames.",
            .place = FigurePlace::monitors};
}

StudyFigure risk_curves(const StudyResults& results) {
    CurveContent content{.title = "Risk against coverage",
                         .second_line = "surest frames first",
                         .y_title = "wrong answers (%)",
                         .panels = {{.x_title = "share of frames answered (%)",
                                     .x_range = {0.0, 100.0},
                                     .curves = {}}}};
    std::size_t colour = 0;
    for (const ConfidenceQuality& quality : results.confidence) {
        Curve curve{.label = short_title(quality.domain), .colour = colour++};
        for (const auto& [x, y] : quality.risk) {
            curve.x.push_back(100.0 * x);
            curve.y.push_back(100.0 * y);
        }
        content.panels[0].curves.push_back(curve);
    }
    return {.figure = curve_figure("risk_coverage", content),
            .caption = "Risk against coverage: errors among the answered frames if only the surest "
                       "are answered.",
            .place = FigurePlace::monitors};
}

StudyFigure drift_forest(const StudyResults& results) {
    double highest = 1.0;
    for (const InputDrift& drift : results.drift) highest = std::max(highest, drift.psi.high);
    ForestContent content{.title = "Population stability of the inputs",
                          .second_line =
                              "population stability index, mean over features; above "
                              "0.25 is called much",
                          .axis_title = "population stability index",
                          .range = {0.0, 1.05 * highest},
                          .series = {"index"},
                          .rows = {},
                          .reference = 0.25,
                          .band_label = "",
                          .csv_unit = "index",
                          .csv_scale = 1.0};
    for (const InputDrift& drift : results.drift)
        content.rows.push_back({.label = short_title(drift.domain), .values = {drift.psi}});
    return {.figure = forest_figure("input_drift", content),
            .caption =
                "Population stability index of the inputs against the training frames, per world, with "
                "95\u00a0% intervals over worlds. Dashed: 0.25.",
            .place = FigurePlace::monitors};
}

}  // namespace

std::vector<StudyFigure> monitor_figures(const StudySummary& study) {
    std::vector<StudyFigure> figures;
    const StudyResults& results = study.results;
    if (!results.detectors.empty()) figures.push_back(detector_matrix(results));
    if (!results.confidence.empty()) {
        figures.push_back(reliability_figures(study));
        figures.push_back(risk_curves(results));
    }
    if (!results.drift.empty()) figures.push_back(drift_forest(results));
    return figures;
}

std::vector<StudyFigure> check_figures(const StudySummary& study) {
    ForestContent content{.title = "Honesty checks",
                          .second_line = "mean over worlds with 95\u00a0% interval over worlds",
                          .axis_title = "macro-F1 (%)",
                          .series = {"value"},
                          .rows = {},
                          .reference = 100.0 / static_cast<double>(std::max<std::size_t>(
                                                   1, study.class_names.size())),
                          .band_label = "band that the interval must reach"};
    for (const HonestyCheck& check : study.results.checks) {
        if (check.name == "merged_at_least" || check.name == "same_nuisance") continue;
        ForestRow row{.label = check.title, .values = {in_percent(check.value)}};
        if (check.band) row.band = {{100.0 * (*check.band)[0], 100.0 * (*check.band)[1]}};
        content.rows.push_back(row);
    }
    if (content.rows.empty()) return {};
    return {{.figure = forest_figure("honesty", content),
             .caption = "Leak meter and negative controls; dashed: chance. A check passes if its "
                        "interval reaches its band; what has no band is reported, not judged.",
             .place = FigurePlace::checks}};
}

}  // namespace specula
