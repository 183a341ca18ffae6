#include "tools/report/paper_agreement.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"

namespace specula {
namespace {

bool is_calibrated(const StudySummary& study, const StudyCondition& condition) {
    return study.calibration && study.calibration->condition == condition.result.name;
}

/// Lowest and highest single world; the mean alone if there are no worlds.
Interval world_range(const ConditionReport& result) {
    const auto [low, high] =
        std::minmax_element(result.macro_f1_per_world.begin(), result.macro_f1_per_world.end());
    if (low == result.macro_f1_per_world.end())
        return {result.macro_f1.mean, result.macro_f1.mean, result.macro_f1.mean};
    return {result.macro_f1.mean, *low, *high};
}

bool contains(const Interval& interval, double value) {
    return interval.low <= value && value <= interval.high;
}

/// "of 20 worlds, 13 lie below the paper\u2019s value"
std::string world_count(const ConditionReport& result, double paper) {
    const auto& worlds = result.macro_f1_per_world;
    const auto n_below =
        std::count_if(worlds.begin(), worlds.end(), [&](double f1) { return f1 < paper; });
    return format("Of {} worlds, {} {} below the paper\u2019s value.", worlds.size(), n_below,
                  n_below == 1 ? "lies" : "lie");
}

std::string mean_offset(const ConditionReport& result, double paper) {
    const double offset = result.macro_f1.mean - paper;
    return format("the simulated mean is {} {}", points_text(std::abs(offset)),
                  offset > 0.0 ? "higher" : "lower");
}

}  // namespace

Agreement paper_agreement(const StudyCondition& condition) {
    if (!condition.paper_macro_f1) return Agreement::unknown;
    if (contains(condition.result.macro_f1, *condition.paper_macro_f1))
        return Agreement::within_interval;
    return contains(world_range(condition.result), *condition.paper_macro_f1)
               ? Agreement::within_worlds
               : Agreement::outside;
}

std::string agreement_verdict(const StudySummary& study, const StudyCondition& condition) {
    if (is_calibrated(study, condition)) return "set to meet the paper";
    switch (paper_agreement(condition)) {
        case Agreement::within_interval:
            return "agrees with the paper";
        case Agreement::within_worlds:
            return "agrees with the paper within the spread of single worlds";
        case Agreement::outside:
            return "differs from the paper";
        case Agreement::unknown:
            break;
    }
    return "no number in the paper";
}

std::string simulated_text(const ConditionReport& result) {
    return format("{} (95\u00a0% interval {})", percent_text(result.macro_f1.mean),
                  range_text(result.macro_f1));
}

std::string agreement_text(const StudySummary& study, const StudyCondition& condition) {
    if (!condition.paper_macro_f1) return "The paper gives no number for this condition.";
    const double paper = *condition.paper_macro_f1;
    const ConditionReport& result = condition.result;
    std::string text = format("The paper reports {}", percent_text(paper));
    switch (paper_agreement(condition)) {
        case Agreement::within_interval:
            text += ", which lies inside the interval.";
            break;
        case Agreement::within_worlds:
            text += format(
                ", outside the interval: {}. It lies within the range of single worlds, "
                "{}, and one world corresponds to one experiment.",
                mean_offset(result, paper), range_text(world_range(result)));
            break;
        default:
            text += format(", outside the interval: {}. All worlds lie {} it; they range from {}.",
                           mean_offset(result, paper),
                           world_range(result).low > paper ? "above" : "below",
                           range_text(world_range(result)));
    }
    text += " " + world_count(result, paper);
    if (is_calibrated(study, condition))
        text += format(
            " This agreement is no evidence: {} was set so that this condition meets the paper.",
            study.calibration->parameter);
    return text;
}

}  // namespace specula
