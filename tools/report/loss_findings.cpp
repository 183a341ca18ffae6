#include <cmath>

#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/paired_difference.hpp"
#include "tools/report/paper_agreement.hpp"
#include "tools/report/study_findings.hpp"
#include "tools/report/study_numbers.hpp"

/// Session, tilt, new samples: where the points go, step by step.
namespace specula {
namespace {

PairedDifference f1_difference(const StudySummary& study, const StudyCondition& a,
                               const StudyCondition& b) {
    return paired_difference(a.result.macro_f1_per_world, b.result.macro_f1_per_world, study.seed);
}

std::string worlds_below(const PairedDifference& difference) {
    return format("lower in {} of {} worlds", difference.n_below, difference.n_worlds);
}

/// Splits the loss from nominal to `condition` at the re-recorded nominal condition.
/// @in  factor  what differs from the re-recorded condition, e.g. "the tilt itself"
std::string decomposition(const StudySummary& study, const StudyCondition& condition,
                          const std::string& factor) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    const StudyCondition* again = find_condition(study, rerecorded_condition);
    if (nominal == nullptr || again == nullptr) return {};
    const PairedDifference total = f1_difference(study, condition, *nominal);
    const PairedDifference session = f1_difference(study, *again, *nominal);
    const PairedDifference rest = f1_difference(study, condition, *again);
    std::string text = format(" Compared with the nominal geometry recorded again, macro-F1 is {}.",
                              difference_text(rest));
    const bool both_lose =
        session.is_clear() && session.value.mean < 0.0 && rest.is_clear() && rest.value.mean < 0.0;
    if (both_lose)
        text += format(
            " So of the {} between nominal and this condition, {} ({}) are already lost by "
            "recording again, and {} are due to {}.",
            points_text(-total.value.mean), points_text(-session.value.mean),
            percent_text(session.value.mean / total.value.mean), points_text(-rest.value.mean),
            factor);
    else if (!rest.is_clear() && rest.n_worlds > 1)
        text += format(" These worlds show no effect of {}.", factor);
    return text;
}

/// Tilting the sample instead of the sensor, if both were done.
std::string other_tilt(const StudySummary& study) {
    const StudyCondition* sensor = find_condition(study, tilt_sensor_condition);
    const StudyCondition* sample = find_condition(study, tilt_sample_condition);
    if (sensor == nullptr || sample == nullptr) return {};
    return format(" Tilting the sample instead of the sensor gives {}, {}{}.",
                  simulated_text(sample->result),
                  difference_text(f1_difference(study, *sample, *sensor)),
                  sample->paper_macro_f1 ? "; " + agreement_verdict(study, *sample) : "");
}

}  // namespace

std::optional<Paragraph> session_finding(const StudySummary& study) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    const StudyCondition* again = find_condition(study, rerecorded_condition);
    if (nominal == nullptr || again == nullptr) return {};
    const PairedDifference loss = f1_difference(study, *again, *nominal);
    const bool loses = loss.is_clear() && loss.value.mean < 0.0;
    std::string text = format(
        "The same samples under the same geometry, recorded in new sessions, give {}. Compared "
        "with "
        "nominal this is {}, and {}.",
        simulated_text(again->result), difference_text(loss), worlds_below(loss));
    if (loses)
        text +=
            " Samples and nominal geometry are the same, so this part of a loss comes with any new "
            "session and is not an effect of height, tilt or samples.";
    return Paragraph{
        .lead = loses ? format("Recording again costs {} by itself.", points_text(-loss.value.mean))
                      : "Recording again shows no clear loss.",
        .text = text + " " + agreement_text(study, *again)};
}

std::optional<Paragraph> tilt_finding(const StudySummary& study) {
    const StudyCondition* sensor = find_condition(study, tilt_sensor_condition);
    const StudyCondition* tilt =
        sensor != nullptr ? sensor : find_condition(study, tilt_sample_condition);
    if (tilt == nullptr) return {};
    return Paragraph{.lead = format("Tilt: {}.", agreement_verdict(study, *tilt)),
                     .text = format("Macro-F1 {} is {}. {}", where(*tilt),
                                    simulated_text(tilt->result), agreement_text(study, *tilt)) +
                             decomposition(study, *tilt, "the tilt itself") + other_tilt(study)};
}

std::optional<Paragraph> similar_finding(const StudySummary& study) {
    const StudyCondition* similar = find_condition(study, similar_condition);
    if (similar == nullptr) return {};
    return Paragraph{
        .lead = format("Similar but unknown samples: {}.", agreement_verdict(study, *similar)),
        .text = format("Other samples of the same materials, in new sessions, give {}. {}",
                       simulated_text(similar->result), agreement_text(study, *similar)) +
                decomposition(study, *similar, "the samples being new")};
}

}  // namespace specula
