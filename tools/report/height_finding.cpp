#include <cmath>

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/paired_difference.hpp"
#include "tools/report/paper_agreement.hpp"
#include "tools/report/study_findings.hpp"
#include "tools/report/study_numbers.hpp"

namespace specula {
namespace {

std::string centimetres(double length_m) {
    return fixed_text(100.0 * length_m, 1) + "\u00a0cm";
}

/// "the echo moves from bin 12.0 to bins 9.3 and 14.7"
std::string echo_text(const StudySummary& study, const StudyCondition& condition) {
    const RadarFacts& radar = study.radar;
    std::vector<std::string> heights, shifts, bins;
    for (const double height_m : condition.heights_m) {
        heights.push_back(centimetres(height_m));
        shifts.push_back(signed_text((height_m - radar.nominal_height_m) / radar.range_bin_m, 1));
        bins.push_back(fixed_text(echo_bin(radar, height_m), 1));
    }
    return format(
        " The heights are {} instead of {}; a range bin is {}, so the echo moves by {} bins, from "
        "bin "
        "{} to {} {}.",
        listed(heights), centimetres(radar.nominal_height_m),
        fixed_text(100.0 * radar.range_bin_m, 2) + "\u00a0cm", listed(shifts),
        fixed_text(radar.nominal_height_bin, 1), bins.size() == 1 ? "bin" : "bins", listed(bins));
}

/// What the classifier says now. Only worth a sentence when one answer is given to most frames.
std::string answers_text(const StudySummary& study, const StudyCondition& condition) {
    const Confusion& confusion = condition.result.confusion;
    const std::size_t answer = most_predicted(confusion);
    if (confusion.n == 0 || predicted_share(confusion, answer) <= 0.5) return {};
    return format(" {} of all frames are called {}, whatever they are.",
                  percent_text(predicted_share(confusion, answer)), study.class_names.at(answer));
}

std::string descriptor_text(const StudySummary& study, const StudyCondition& condition) {
    if (condition.features.empty()) return {};
    const int first = study.radar.first_descriptor_bin;
    const int last = first + static_cast<int>(condition.features.front().mean.size()) - 1;
    return format(
        " The descriptor reads bins {} to {} at every height, so each of its inputs then "
        "holds another part of the echo than in training.",
        first, last);
}

}  // namespace

std::optional<Paragraph> height_finding(const StudySummary& study) {
    const StudyCondition* height = find_condition(study, height_condition);
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    if (height == nullptr || nominal == nullptr) return {};
    const ConditionReport& result = height->result;
    const PairedDifference loss = paired_difference(result.macro_f1_per_world,
                                                    nominal->result.macro_f1_per_world, study.seed);
    const double chance = 1.0 / static_cast<double>(study.class_names.size());
    std::string text =
        format("Macro-F1 {} is {}; compared with nominal this is {}; chance is {}.", where(*height),
               simulated_text(result), difference_text(loss), percent_text(chance));
    if (!height->heights_m.empty() && study.radar.range_bin_m > 0.0)
        text += echo_text(study, *height) + descriptor_text(study, *height);
    const std::string lead = result.macro_f1.high < chance ? "below chance"
                             : loss.is_clear() && loss.value.mean < 0.0
                                 ? points_text(-loss.value.mean) + " lost"
                                 : "no clear loss";
    return Paragraph{
        .lead = format("Height: {}; {}.", lead, agreement_verdict(study, *height)),
        .text = text + answers_text(study, *height) + " " + agreement_text(study, *height)};
}

}  // namespace specula
