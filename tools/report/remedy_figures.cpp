#include "sim/core/format.hpp"
#include "tools/report/forest_figure.hpp"
#include "tools/report/heat_figure.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/result_figures.hpp"

namespace specula {
namespace {

StudyFigure ladder_matrix(const StudySummary& study) {
    const auto& ladder = study.results.ladder;
    HeatContent content{.title = "Remedies in every condition",
                        .second_line = "macro-F1 (%), mean over worlds and trainings",
                        .column_title = "",
                        .rows = {},
                        .columns = {},
                        .emphasised = {},
                        .panels = {{study.merged_label, {}}}};
    for (const DomainScore& score : ladder.front().domains)
        content.columns.push_back(short_title(score.domain));
    for (const LadderRung& rung : ladder) {
        content.rows.push_back(rung.title);
        content.emphasised.push_back(rung.recommended);
        std::vector<std::optional<double>> merged;
        for (const DomainScore& score : rung.domains) merged.emplace_back(score.merged.mean);
        content.panels[0].shares.push_back(merged);
    }
    return {.figure = heat_figure("ladder", content),
            .caption =
                "The ladder, merged classes: every remedy on the same worlds and frames, "
                "with as many rows and steps. Bold: recommended, the rung whose worst "
                "condition is best.",
            .place = FigurePlace::remedies};
}

StudyFigure ladder_gains(const StudySummary& study) {
    const auto& ladder = study.results.ladder;
    ForestContent content{
        .title = "What each remedy gains",
        .second_line = "paired by worlds, 95\u00a0% interval; all classes",
        .axis_title = "change of macro-F1 against the paper's classifier (points)",
        .range = {-50.0, 90.0},
        .series = {},
        .rows = {},
        .reference = 0.0,
        .band_label = ""};
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < ladder.front().domains.size(); ++i) {
        const std::string& domain = ladder.front().domains[i].domain;
        if (domain != height_condition && domain != tilt_sample_condition &&
            domain != similar_condition)
            continue;
        shown.push_back(i);
        content.series.push_back(short_title(domain));
    }
    if (shown.empty()) {
        shown.push_back(0);
        content.series.push_back(short_title(ladder.front().domains.front().domain));
    }
    for (std::size_t rung = 1; rung < ladder.size(); ++rung) {
        ForestRow row{
            .label = ladder[rung].title, .values = {}, .emphasised = ladder[rung].recommended};
        for (const std::size_t domain : shown)
            row.values.emplace_back(in_percent(ladder[rung].gain[domain]));
        content.rows.push_back(row);
    }
    return {.figure = forest_figure("ladder_gains", content),
            .caption =
                "Paired differences to the first rung, all classes. An interval that "
                "includes zero is no effect.",
            .place = FigurePlace::remedies};
}

}  // namespace

std::vector<StudyFigure> remedy_figures(const StudySummary& study) {
    if (study.results.ladder.size() < 2) return {};
    return {ladder_matrix(study), ladder_gains(study)};
}

}  // namespace specula
