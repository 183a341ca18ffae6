#include "sim/core/format.hpp"
#include "tools/report/gain_figure.hpp"
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
                        .panels = {{format("{} classes", study.class_names.size()), {}},
                                   {study.merged_label, {}}}};
    for (const DomainScore& score : ladder.front().domains)
        content.columns.push_back(short_title(score.domain));
    for (const LadderRung& rung : ladder) {
        content.rows.push_back(rung.title);
        content.emphasised.push_back(rung.recommended);
        std::vector<std::optional<double>> all, merged;
        for (const DomainScore& score : rung.domains) {
            all.emplace_back(score.all.mean);
            merged.emplace_back(score.merged.mean);
        }
        content.panels[0].shares.push_back(all);
        content.panels[1].shares.push_back(merged);
    }
    return {.figure = heat_figure("ladder", content),
            .caption =
                "The ladder: every remedy on the same worlds and frames, with as many rows and "
                "steps, classes apart (left) and merged (right). Bold: recommended, the rung "
                "whose worst condition, merged, is best on every other world.",
            .place = FigurePlace::remedies};
}

StudyFigure ladder_gains(const StudySummary& study) {
    const auto& ladder = study.results.ladder;
    GainContent content{
        .title = "What each remedy gains over the paper\u2019s classifier",
        .second_line = "paired by worlds, 95\u00a0% interval over worlds; axes differ",
        .series = {format("{} classes", study.class_names.size()), study.merged_label},
        .panels = {},
        .rows = {}};
    for (const DomainScore& score : ladder.front().domains)
        content.panels.push_back(short_title(score.domain));
    for (std::size_t i = 1; i < ladder.size(); ++i) {
        GainRow row{.label = ladder[i].title, .emphasised = ladder[i].recommended, .values = {}};
        for (std::size_t domain = 0; domain < content.panels.size(); ++domain)
            row.values.push_back({ladder[i].gain[domain], ladder[i].gain_merged[domain]});
        content.rows.push_back(std::move(row));
    }
    return {.figure = gain_figure("ladder_gains", content),
            .caption =
                "Paired differences to the first rung in every condition, classes apart and "
                "merged. An interval that includes zero is no effect.",
            .place = FigurePlace::remedies};
}

}  // namespace

std::vector<StudyFigure> remedy_figures(const StudySummary& study) {
    if (study.results.ladder.size() < 2) return {};
    return {ladder_matrix(study), ladder_gains(study)};
}

}  // namespace specula
