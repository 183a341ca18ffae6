#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/study_findings.hpp"
#include "tools/report/study_numbers.hpp"

/// What the confidence says, and what the inputs say instead.
namespace specula {
namespace {

/// The paper's threshold for "high" (section on the nominal confidence distribution), moved up to
/// the next edge of the histogram.
constexpr double high_confidence = 0.9;

enum class Direction { lower, unclear, higher };

/// Clear only if the intervals do not touch.
Direction direction(const Interval& value, const Interval& reference) {
    if (value.high < reference.low) return Direction::lower;
    return value.low > reference.high ? Direction::higher : Direction::unclear;
}

std::string change_text(const StudyCondition& condition, const StudyCondition& nominal) {
    const Interval& value = condition.result.mean_confidence;
    const Interval& reference = nominal.result.mean_confidence;
    const double change = value.mean - reference.mean;
    switch (direction(value, reference)) {
        case Direction::lower:
            return points_text(-change) + " below nominal";
        case Direction::higher:
            return points_text(change) + " above nominal";
        case Direction::unclear:
            break;
    }
    return "not clearly different from nominal";
}

std::string nominal_text(const StudyCondition& nominal) {
    const auto n_bins = static_cast<double>(ConfidenceHistogram::n_bins);
    const auto first = static_cast<std::size_t>(std::ceil(high_confidence * n_bins - 1e-9));
    return format(
        "Under the nominal geometry {} of the correct and {} of the wrong frames have a "
        "confidence above {}.",
        percent_text(share_above(nominal.result.confidence.correct, first)),
        percent_text(share_above(nominal.result.confidence.wrong, first)),
        fixed_text(static_cast<double>(first) / n_bins, 2));
}

/// The paper finds lower confidence under tilt and on similar samples; here one sentence for each.
std::string paper_claim_text(const StudyCondition* condition, const StudyCondition& nominal) {
    if (condition == nullptr) return {};
    const char* verdict = "the paper reports lower confidence, which these intervals do not settle";
    const auto found = direction(condition->result.mean_confidence, nominal.result.mean_confidence);
    if (found == Direction::lower) verdict = "as in the paper, confidence falls";
    if (found == Direction::higher) verdict = "contrary to the paper, confidence rises";
    return format(" Mean confidence {} is {}, {}: {}.", where(*condition),
                  percent_text(condition->result.mean_confidence.mean),
                  change_text(*condition, nominal), verdict);
}

std::string height_text(const StudyCondition* height, const StudyCondition& nominal) {
    if (height == nullptr) return {};
    std::string text = format(
        " Mean confidence {} is {}, {}, while {} of the frames are classified "
        "correctly.",
        where(*height), percent_text(height->result.mean_confidence.mean),
        change_text(*height, nominal), percent_text(accuracy(height->result.confusion)));
    if (direction(height->result.mean_confidence, nominal.result.mean_confidence) !=
        Direction::lower)
        text += " A threshold on mean confidence would not notice this shift.";
    return text;
}

struct Drift {
    const StudyCondition* condition;
    double value;
};

std::vector<Drift> drifts(const StudySummary& study) {
    std::vector<Drift> all;
    for (const StudyCondition& condition : study.conditions)
        if (condition.result.name != nominal_condition)
            if (const InputDrift* const drift = find_drift(study, condition.result.name))
                all.push_back({&condition, drift->mean_shift.mean});
    return all;
}

}  // namespace

std::optional<Paragraph> confidence_finding(const StudySummary& study) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    if (nominal == nullptr) return {};
    return Paragraph{
        .lead = "Confidence.",
        .text = nominal_text(*nominal) +
                paper_claim_text(find_condition(study, tilt_sensor_condition), *nominal) +
                paper_claim_text(find_condition(study, similar_condition), *nominal) +
                height_text(find_condition(study, height_condition), *nominal)};
}

std::optional<Paragraph> monitor_finding(const StudySummary& study) {
    const std::vector<Drift> all = drifts(study);
    if (all.empty()) return {};
    std::vector<std::string> items;
    for (const Drift& drift : all)
        items.push_back(fixed_text(drift.value, 2) + " " + where(*drift.condition));
    const auto largest = std::max_element(
        all.begin(), all.end(), [](const Drift& a, const Drift& b) { return a.value < b.value; });
    return Paragraph{
        .lead = "Mean shift of the inputs.",
        .text =
            format("On average over features and worlds, the mean of an input moves from that of "
                   "the training frames, in their standard deviations, by {}. It moves most {}.",
                   listed(items), where(*largest->condition))};
}

}  // namespace specula
