#include "tools/report/study_tables.hpp"

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/study_numbers.hpp"

namespace specula {
namespace {

constexpr const char* none = "\u2013";

std::string f1_note(const StudySummary& study) {
    std::string note =
        "Intervals are 95\u00a0% percentile bootstraps over worlds, and within them over "
        "sessions. A world is one draw of samples, "
        "placements, clutter and sessions. Frames are not resampled: frames of one session are not "
        "independent. Difference: simulated minus paper, in points.";
    if (study.calibration)
        if (const StudyCondition* matched = find_condition(study, study.calibration->condition))
            note += format(" \u201c{}\u201d meets the paper by calibration: {} was set so.",
                           matched->result.title, study.calibration->parameter);
    return note;
}

std::vector<std::string> f1_row(const StudyCondition& condition) {
    const ConditionReport& result = condition.result;
    const auto& paper = condition.paper_macro_f1;
    return {result.title,
            paper ? percent_number(*paper) : none,
            percent_number(result.macro_f1.mean),
            range_number(result.macro_f1),
            paper ? signed_text(100.0 * (result.macro_f1.mean - *paper), 1) : none,
            percent_number(result.macro_f1_merged.mean),
            range_number(result.macro_f1_merged),
            percent_number(result.mean_confidence.mean),
            count_text(result.n_frames)};
}

}  // namespace

ReportTable macro_f1_table(const StudySummary& study) {
    const std::string all = format("Simulated, {} classes", study.class_names.size());
    ReportTable table{.caption = "Macro-F1 (%) of every condition, in the paper and simulated.",
                      .columns = {{"", "Condition", false},
                                  {"", "Paper"},
                                  {all, "mean"},
                                  {all, "95\u00a0%\u00a0interval"},
                                  {all, "difference"},
                                  {study.merged_label, "mean"},
                                  {study.merged_label, "95\u00a0%\u00a0interval"},
                                  {"", "Mean confidence\u00a0(%)"},
                                  {"", "Frames"}},
                      .rows = {},
                      .note = f1_note(study)};
    for (const StudyCondition& condition : study.conditions)
        table.rows.push_back(f1_row(condition));
    return table;
}

ReportTable monitor_table(const StudySummary& study) {
    ReportTable table{
        .caption =
            "What could warn of a shift. Mean shift: how far the mean of a feature has moved from "
            "the training frames, in their standard deviations; mean over features and worlds. "
            "Overconfidence: mean confidence minus share of correct frames.",
        .columns = {{"", "Condition", false},
                    {"", "Mean shift (sd of training)"},
                    {"", "Mean confidence (%)"},
                    {"", "Correct frames (%)"},
                    {"", "Overconfidence (points)"}},
        .rows = {},
        .note = {}};
    for (const StudyCondition& condition : study.conditions) {
        const ConditionReport& result = condition.result;
        const InputDrift* const drift = find_drift(study, result.name);
        const double correct = accuracy(result.confusion);
        table.rows.push_back({result.title, drift ? fixed_text(drift->mean_shift.mean, 2) : none,
                              percent_number(result.mean_confidence.mean), percent_number(correct),
                              signed_text(100.0 * (result.mean_confidence.mean - correct), 1)});
    }
    return table;
}

}  // namespace specula
