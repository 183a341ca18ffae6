#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/curve_figure.hpp"
#include "tools/report/forest_figure.hpp"
#include "tools/report/heat_figure.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/result_figures.hpp"

namespace specula {
namespace {

StudyFigure waterfall_figure(const StudySummary& study) {
    ForestContent content{
        .title = "Where the loss arises",
        .second_line = "mean over worlds with 95\u00a0% interval over worlds and sessions; the loss is paired by worlds",
        .axis_title = "macro-F1 (%)",
        .series = {format("{} classes", study.class_names.size()), study.merged_label},
        .rows = {}};
    for (const WaterfallStep& step : study.results.waterfall) {
        const std::string loss =
            step.loss ? format(" ({})", signed_text(100.0 * step.loss->mean, 1)) : "";
        content.rows.push_back({.label = step.title + loss,
                                .values = {in_percent(step.all), in_percent(step.merged)}});
    }
    return {.figure = forest_figure("waterfall", content),
            .caption =
                "Attribution. From random frames of the training sessions to new sessions, "
                "and from there to each shift; in brackets the change in points, all "
                "classes, against the step it begins from.",
            .place = FigurePlace::attribution};
}

StudyFigure sensitivity_figure(const StudySummary& study) {
    const auto& rows = study.results.sensitivity;
    HeatContent content{
        .title = "What each assumption carries",
        .second_line = "macro-F1 (%), one assumption changed at a time",
        .column_title = "",
        .rows = {},
        .columns = {},
        .emphasised = {},
        .panels = {{format("{} classes", study.class_names.size()), {}}, {study.merged_label, {}}}};
    for (const DomainScore& score : rows.front().domains)
        content.columns.push_back(short_title(score.domain));
    for (const SensitivityRow& row : rows) {
        content.rows.push_back(row.title);
        content.emphasised.push_back(&row == &rows.front());
        std::vector<std::optional<double>> all, merged;
        for (const DomainScore& score : row.domains) {
            all.emplace_back(score.all.mean);
            merged.emplace_back(score.merged.mean);
        }
        content.panels[0].shares.push_back(all);
        content.panels[1].shares.push_back(merged);
    }
    return {
        .figure = heat_figure("sensitivity", content),
        .caption = format("Sensitivity to what the paper leaves open, {} worlds each. Every row "
                          "is recorded and trained anew; the first is the study's own set of "
                          "assumptions. A row with another ratio of signal to noise names what "
                          "that ratio gives nominally over the worlds it was searched on, which "
                          "are more than those of the row.",
                          rows.front().domains.front().per_world.all.size()),
        .place = FigurePlace::attribution};
}

StudyFigure prior_figure(const StudySummary& study) {
    const PriorPrediction& prior = study.results.prior;
    CurveContent content{
        .title = "What the simulator predicts before it is told",
        .second_line =
            format("{} draws of all assumptions at once, one world each", prior.draws.size()),
        .y_title = "macro-F1 under the shift (%)",
        .panels = {}};
    double paper_nominal = 0.0, paper_tilt = 0.0;
    for (const StudyCondition& condition : study.conditions) {
        if (!condition.paper_macro_f1) continue;
        (condition.result.name == nominal_condition ? paper_nominal : paper_tilt) =
            100.0 * *condition.paper_macro_f1;
    }
    for (std::size_t i = 0; i < prior.domains.size(); ++i) {
        const std::string& domain = prior.domains[i];
        const bool is_tilt = domain == tilt_sensor_condition || domain == tilt_sample_condition;
        if (!is_tilt && domain != height_condition) continue;
        Curve kept{.label = "nominal meets the paper's within 2 points", .points_only = true},
            other{.label = "other draws", .points_only = true, .colour = 6};
        for (const PriorDraw& draw : prior.draws) {
            Curve& curve = draw.accepted ? kept : other;
            curve.x.push_back(100.0 * draw.nominal);
            curve.y.push_back(100.0 * draw.domains[i]);
        }
        CurvePanel panel{.x_title = "nominal (%), " + short_title(domain),
                         .x_range = {40.0, 100.0},
                         .curves = {other, kept},
                         .diagonal = true};
        if (is_tilt && paper_tilt > 0.0) panel.star = {{paper_nominal, paper_tilt}};
        content.panels.push_back(panel);
    }
    return {.figure = curve_figure("prior_predictive", content),
            .caption =
                "Prior-predictive scatter: macro-F1 of random frames against that under the "
                "shift. Dashed: nothing lost. Star: the paper, which says neither which of "
                "the two was tilted nor the samples' size.",
            .place = FigurePlace::attribution};
}

}  // namespace

std::string short_title(const std::string& condition) {
    static const std::vector<std::pair<std::string_view, std::string>> titles{
        {nominal_condition, "Random frames"},
        {rerecorded_condition, "New sessions"},
        {height_condition, "Height"},
        {tilt_sensor_condition, "Sensor tilted"},
        {tilt_sample_condition, "Sample tilted"},
        {similar_condition, "Other samples"},
        {joint_condition, "Height and tilt"}};
    for (const auto& [name, title] : titles)
        if (name == condition) return title;
    return condition;
}

Interval in_percent(const Interval& share) {
    return {100.0 * share.mean, 100.0 * share.low, 100.0 * share.high};
}

std::vector<StudyFigure> attribution_figures(const StudySummary& study) {
    std::vector<StudyFigure> figures;
    if (study.results.waterfall.size() > 1) figures.push_back(waterfall_figure(study));
    if (!study.results.sensitivity.empty()) figures.push_back(sensitivity_figure(study));
    const auto& shifted = study.results.prior.domains;
    const bool has_panel = std::ranges::any_of(shifted, [](const std::string& domain) {
        return domain == tilt_sensor_condition || domain == tilt_sample_condition ||
               domain == height_condition;
    });
    if (!study.results.prior.draws.empty() && has_panel) figures.push_back(prior_figure(study));
    return figures;
}

}  // namespace specula
