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

PaperPercentile among_worlds(const StudyCondition& condition) {
    return percentile_of(*condition.paper_macro_f1, condition.result.macro_f1_per_world);
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

PaperPercentile percentile_of(double paper, std::vector<double> predicted) {
    PaperPercentile result{.paper = paper, .n = predicted.size()};
    if (predicted.empty()) return result;
    std::sort(predicted.begin(), predicted.end());
    const auto below = std::lower_bound(predicted.begin(), predicted.end(), paper);
    result.percentile =
        static_cast<double>(below - predicted.begin()) / static_cast<double>(predicted.size());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(predicted.size() - 1);
        const auto low = static_cast<std::size_t>(place);
        const std::size_t high = std::min(low + 1, predicted.size() - 1);
        const double part = place - static_cast<double>(low);
        return (1.0 - part) * predicted[low] + part * predicted[high];
    };
    result.prediction = {at(0.5), at(0.05), at(0.95)};
    return result;
}

Agreement paper_agreement(const StudyCondition& condition) {
    if (!condition.paper_macro_f1) return Agreement::unknown;
    const PaperPercentile worlds = among_worlds(condition);
    if (!worlds.has_percentiles()) return Agreement::too_few;
    if (!worlds.agrees()) return Agreement::outside;
    return contains(condition.result.macro_f1, *condition.paper_macro_f1)
               ? Agreement::within_interval
               : Agreement::within_worlds;
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
        case Agreement::too_few:
            return "too few worlds to judge the paper\u2019s number";
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
    const Agreement agreement = paper_agreement(condition);
    if (agreement == Agreement::too_few)
        text += format("; fewer than {} worlds are too few to say whether they agree.",
                       least_predictions);
    else
        text += format(
            ", {} the 5th to 95th percentile of single worlds, {}; one world corresponds to one "
            "experiment. It lies {} the interval of the mean: {}.",
            agreement == Agreement::outside ? "outside" : "within",
            range_text(among_worlds(condition).prediction),
            contains(result.macro_f1, paper) ? "inside" : "outside", mean_offset(result, paper));
    text += " " + world_count(result, paper);
    if (is_calibrated(study, condition))
        text += format(
            " This agreement is no evidence: {} was set so that this condition meets the paper.",
            study.calibration->parameter);
    return text;
}

}  // namespace specula
