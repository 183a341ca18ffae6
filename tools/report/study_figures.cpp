#include "tools/report/study_figures.hpp"

#include "sim/core/format.hpp"
#include "tools/report/confidence_figure.hpp"
#include "tools/report/confusion_figure.hpp"
#include "tools/report/f1_figure.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/range_profile_figure.hpp"
#include "tools/report/result_figures.hpp"

namespace specula {
namespace {

enum class Kind { confusion, confidence };

/// `paper_figure` is the number of the figure in the paper; 0: the paper shows none.
struct PaperFigure {
    std::string_view condition, name;
    Kind kind;
    int paper_figure;
};

/// Names are the labels of the paper's LaTeX source; its Fig. 1 is a photograph of the set-up.
constexpr PaperFigure paper_figures[] = {
    {nominal_condition, "confusion_baseline", Kind::confusion, 2},
    {nominal_condition, "confidence_baseline", Kind::confidence, 3},
    {height_condition, "confusion_height", Kind::confusion, 4},
    {tilt_sensor_condition, "confidence_unknown", Kind::confidence, 5},
    {similar_condition, "confusion_similar", Kind::confusion, 6},
    {similar_condition, "confidence_similar", Kind::confidence, 7},
    {tilt_sensor_condition, "confusion_tilt", Kind::confusion, 0},
    {height_condition, "confidence_height", Kind::confidence, 0},
};

std::string caption(const PaperFigure& wanted, const ConditionReport& result) {
    const std::string source =
        wanted.paper_figure > 0 ? format("Compare Fig.\u00a0{} of the paper.", wanted.paper_figure)
                                : "The paper does not show this one.";
    if (wanted.kind == Kind::confusion)
        return format(
            "{}, confusion matrix. Share of each true class and number of frames, all worlds "
            "together; the diagonal is the recall. {}",
            result.title, source);
    return format(
        "{}, confidence. Distribution over correctly and over wrongly classified frames, all "
        "worlds together; each of the two adds up to 100\u00a0%. {}",
        result.title, source);
}

StudyFigure paper_figure(const PaperFigure& wanted, const StudySummary& study,
                         const ConditionReport& result) {
    const std::string name(wanted.name);
    return {.figure = wanted.kind == Kind::confusion
                          ? confusion_figure(name, result, study.class_names)
                          : confidence_figure(name, result),
            .caption = caption(wanted, result),
            .place = FigurePlace::paper};
}

StudyFigure overview(const StudySummary& study) {
    const std::size_t n_classes = study.class_names.size();
    F1Rows content{.rows = {},
                   .n_classes = n_classes,
                   .all_label = format("{} classes", n_classes),
                   .merged_label = study.merged_label};
    for (const StudyCondition& condition : study.conditions) {
        const ConditionReport& result = condition.result;
        content.rows.push_back({result.name, result.title, result.macro_f1, result.macro_f1_merged,
                                result.macro_f1_per_world, result.macro_f1_merged_per_world,
                                condition.paper_macro_f1});
    }
    return {.figure = f1_figure("macro_f1", content),
            .caption =
                "Macro-F1 of every condition. Large markers: mean over worlds with its "
                "95\u00a0% interval; small points: single worlds; stars: the paper.",
            .place = FigurePlace::overview};
}

StudyFigure drift(const StudySummary& study, const std::vector<ProfilePanel>& panels) {
    const RadarFacts& radar = study.radar;
    const bool has_mark = radar.nominal_height_bin > 0.0;
    return {
        .figure = range_profile_figure(
            "descriptor_drift",
            {.panels = panels,
             .class_names = study.class_names,
             .first_bin = radar.first_descriptor_bin,
             .quantity = radar.feature_quantity,
             .marked_bin = has_mark ? std::optional(radar.nominal_height_bin) : std::nullopt}),
        .caption = format("The descriptor of every class under each condition: mean over frames "
                          "and band of one standard deviation either side.{}",
                          has_mark ? format(" Dashed: where the echo of the nominal height lies, "
                                            "bin {}.",
                                            fixed_text(radar.nominal_height_bin, 1))
                                   : ""),
        .place = FigurePlace::drift};
}

}  // namespace

std::vector<StudyFigure> study_figures(const StudySummary& study) {
    std::vector<StudyFigure> figures{overview(study)};
    for (const PaperFigure& wanted : paper_figures)
        if (const StudyCondition* condition = find_condition(study, wanted.condition))
            figures.push_back(paper_figure(wanted, study, condition->result));
    std::vector<ProfilePanel> panels;
    for (const StudyCondition& condition : study.conditions)
        if (!condition.features.empty())
            panels.push_back({condition.result.name, condition.result.title, condition.features});
    if (!panels.empty()) figures.push_back(drift(study, panels));
    for (const auto part :
         {attribution_figures, remedy_figures, severity_figures, check_figures, monitor_figures})
        for (StudyFigure& figure : part(study)) figures.push_back(std::move(figure));
    return figures;
}

}  // namespace specula
