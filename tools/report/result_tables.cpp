#include "tools/report/result_tables.hpp"

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/result_figures.hpp"

namespace specula {
namespace {

constexpr const char* none = "\u2013";

std::string kibibytes(std::size_t bytes) {
    return fixed_text(static_cast<double>(bytes) / 1024.0, 1);
}

std::string verdict(const HonestyCheck& check) {
    if (!check.band) return "reported";
    return format("{}{}", check.passed ? "passed" : "FAILED", check.is_weak() ? ", weak" : "");
}

std::string band_text(const HonestyCheck& check) {
    return check.band ? format("{} to {}", percent_number((*check.band)[0]),
                               percent_number((*check.band)[1]))
                      : none;
}

ReportTable fallback_table(const StudySummary& study) {
    ReportTable table{
        .caption =
            "A monitor with fallback: frames whose 12 inputs lie beyond the training's 99th "
            "percentile of Mahalanobis distance get no answer.",
        .columns = {{"", "Condition", false},
                    {"", "Answered frames (%)"},
                    {"", "Right among them (%)"},
                    {"", "Right among all (%)"}},
        .rows = {},
        .note = {}};
    for (const FallbackScore& score : study.results.fallback)
        table.rows.push_back(
            {short_title(score.domain), percent_number(score.answered.mean),
             score.accuracy ? percent_number(score.accuracy->mean) : none,
             percent_number(score.accuracy_all.mean)});
    return table;
}

}  // namespace

WorstScores worst_of(const std::vector<DomainScore>& domains) {
    WorstScores worst{.all = domains.front().all, .merged = domains.front().merged};
    for (const DomainScore& score : domains) {
        if (score.all.mean < worst.all.mean) worst.all = score.all;
        if (score.merged.mean < worst.merged.mean) worst.merged = score.merged;
    }
    return worst;
}

std::vector<ReportTable> part_tables(const StudySummary& study) {
    if (study.parts.empty()) return {};
    ReportTable table{.caption = "Conditions of several heights or tilts, one by one.",
                      .columns = {{"", "Condition", false},
                                  {"", "Macro-F1 (%)"},
                                  {"", "95\u00a0%\u00a0interval"},
                                  {"", "Merged (%)"},
                                  {"", "Frames"}},
                      .rows = {},
                      .note = {}};
    for (const StudyCondition& part : study.parts)
        table.rows.push_back({part.result.title, percent_number(part.result.macro_f1.mean),
                              range_number(part.result.macro_f1),
                              percent_number(part.result.macro_f1_merged.mean),
                              count_text(part.result.n_frames)});
    return {table};
}

std::vector<ReportTable> attribution_tables(const StudySummary& study) {
    if (study.results.percentiles.empty()) return {};
    ReportTable table{
        .caption = "The paper\u2019s tilt figure within what is predicted.",
        .columns = {{"", "Prediction", false},
                    {"", "Over", false},
                    {"", "n"},
                    {"", "Median (%)"},
                    {"", "5th to 95th percentile"},
                    {"", "Paper (%)"},
                    {"", "Its percentile"}},
        .rows = {},
        .note = format("Agreement within so wide an interval is a check of consistency, no proof. "
                       "Fewer than {} predictions have no percentiles.",
                       least_predictions)};
    for (const PaperPercentile& entry : study.results.percentiles)
        table.rows.push_back(
            {short_title(entry.domain), entry.over, format("{}", entry.n),
             percent_number(entry.prediction.mean),
             entry.has_percentiles() ? range_number(entry.prediction) : none,
             percent_number(entry.paper),
             entry.has_percentiles() ? fixed_text(100.0 * entry.percentile, 0) : none});
    return {table};
}

std::vector<ReportTable> remedy_tables(const StudySummary& study) {
    const auto& ladder = study.results.ladder;
    if (ladder.empty()) return {};
    ReportTable table{
        .caption =
            "What the remedies cost and give. Times are estimates for the chip, of what "
            "comes after the range profile: multiplications times the cycles that the "
            "traced network of the paper takes per multiplication.",
        .columns = {{"", "Remedy", false},
                    {"Costs", "inputs"},
                    {"Costs", "multi\u00adplications"},
                    {"Costs", "KiB"},
                    {"Costs", "\u00b5s, estimated"},
                    {"Random frames (%)", "all"},
                    {"Random frames (%)", "95\u00a0%\u00a0interval"},
                    {"Worst condition (%)", "all"},
                    {"Worst condition (%)", "merged"},
                    {"Worst condition (%)", "95\u00a0%\u00a0interval, merged"}},
        .rows = {},
        .note =
            "Same worlds, frames, rows and steps for all, but where a title says more; the network "
            "of the last epoch counts. Intervals are over worlds. Recommended is what does best "
            "on every other world; the table is over all, the summary gives the rest alone. The "
            "time of several looks is that of one, at an eighth of the "
            "rate of answers."};
    for (const LadderRung& rung : ladder) {
        const WorstScores worst = worst_of(rung.domains);
        const Interval& random = rung.domains.front().all;
        table.rows.push_back({rung.title + (rung.recommended ? " (recommended)" : ""),
                              format("{}", rung.cost.n_features),
                              count_text(static_cast<std::int64_t>(rung.cost.multiplications)),
                              kibibytes(rung.cost.model_bytes),
                              format("{:.0f} to {:.0f}", rung.cost.low_us, rung.cost.high_us),
                              percent_number(random.mean), range_number(random),
                              percent_number(worst.all.mean), percent_number(worst.merged.mean),
                              range_number(worst.merged)});
    }
    return {table};
}

std::vector<ReportTable> severity_tables(const StudySummary& study) {
    const SeverityGrid& grid = study.results.severity;
    if (grid.cells.empty()) return {};
    ReportTable table{.caption =
                          "The grid in one number: mean over all its shifted cells, and the "
                          "error relative to the paper\u2019s classifier.",
                      .columns = {{"", "Classifier", false},
                                  {"", "Mean macro-F1 (%)"},
                                  {"", "Merged (%)"},
                                  {"", "Relative error (%)"}},
                      .rows = {},
                      .note = {}};
    for (std::size_t i = 0; i < grid.classifiers.size(); ++i)
        table.rows.push_back({grid.classifiers[i], percent_number(grid.mean_all[i]),
                              percent_number(grid.mean_merged[i]),
                              percent_number(grid.relative_error[i])});
    return {table};
}

std::vector<ReportTable> check_tables(const StudySummary& study) {
    if (study.results.checks.empty()) return {};
    ReportTable table{.caption = "Honesty checks. A check passes if its 95\u00a0% interval over worlds "
                                 "reaches its band.",
                      .columns = {{"", "Check", false},
                                  {"", "Value (%)"},
                                  {"", "95\u00a0%\u00a0interval"},
                                  {"", "Band (%)"},
                                  {"", "Verdict", false},
                                  {"", "Why", false}},
                      .rows = {},
                      .note = format("Weak: of fewer than {} worlds, or with an interval wider "
                                     "than its band, so that passing says little. What is one "
                                     "number of all worlds together has no interval.",
                                     few_worlds)};
    for (const HonestyCheck& check : study.results.checks)
        table.rows.push_back({check.title, percent_number(check.value.mean),
                              check.has_interval() ? range_number(check.value) : none,
                              band_text(check), verdict(check), check.reason});
    return {table};
}

std::vector<ReportTable> confidence_tables(const StudySummary& study) {
    if (study.results.confidence.empty()) return {};
    ReportTable table{
        .caption = "How far confidence can be believed, all worlds together.",
        .columns = {{"", "Condition", false},
                    {"Calibration error (%)", "raw"},
                    {"Calibration error (%)", "scaled"},
                    {"", "NLL (nats)"},
                    {"", "Brier"},
                    {"", "AURC (%)"},
                    {"", "Coverage at 5\u00a0% risk (%)"}},
        .rows = {},
        .note = format("Scaled: with temperature {}, fitted on held-back nominal frames.",
                       fixed_text(study.results.temperature, 2))};
    for (const ConfidenceQuality& quality : study.results.confidence)
        table.rows.push_back({short_title(quality.domain), percent_number(quality.ece),
                              percent_number(quality.ece_scaled), fixed_text(quality.nll, 2),
                              fixed_text(quality.brier, 2), percent_number(quality.aurc),
                              percent_number(quality.coverage_at_5_percent)});
    std::vector<ReportTable> tables{table};
    if (!study.results.fallback.empty()) tables.push_back(fallback_table(study));
    return tables;
}

}  // namespace specula
