#include "sim/core/format.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/paired_difference.hpp"
#include "tools/report/study_findings.hpp"
#include "tools/report/study_numbers.hpp"

namespace specula {
namespace {

std::string gain(const StudySummary& study, const StudyCondition& condition) {
    return difference_text(paired_difference(condition.result.macro_f1_merged_per_world,
                                             condition.result.macro_f1_per_world, study.seed));
}

std::string nominal_text(const StudySummary& study, const StudyCondition& nominal) {
    const MergedClasses m = merged_classes(nominal.result.confusion, study.merged_classes);
    return format(
        "Under the nominal geometry {} of all wrong frames are confusions of {} with each "
        "other. Of the "
        "frames of these classes that are called one of them, {} get the right one; guessing "
        "would give {}.",
        percent_text(m.share_of_errors), merged_names(study), percent_text(m.right_within),
        percent_text(m.guessing));
}

/// How much of the advantage over guessing survives new recordings of the same samples.
std::string again_text(const StudySummary& study, const StudyCondition& nominal,
                       const StudyCondition& again) {
    const MergedClasses before = merged_classes(nominal.result.confusion, study.merged_classes);
    const MergedClasses after = merged_classes(again.result.confusion, study.merged_classes);
    std::string text = format(" When the same samples are recorded again {} do.",
                              percent_text(after.right_within));
    const double margin = before.right_within - before.guessing;
    const double lost = before.right_within - after.right_within;
    if (margin > 0.0 && lost > 0.0)
        text += format(
            " The advantage over guessing falls from {} to {}: what is lost belongs to the "
            "recordings and not to the materials.",
            points_text(margin), points_text(after.right_within - after.guessing));
    return text;
}

}  // namespace

std::optional<Paragraph> merged_finding(const StudySummary& study) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    const StudyCondition* again = find_condition(study, rerecorded_condition);
    if (nominal == nullptr || study.merged_classes.size() < 2) return {};
    std::string text = nominal_text(study, *nominal);
    if (again != nullptr) text += again_text(study, *nominal, *again);
    text += format(" With these classes counted as one, macro-F1 under the nominal geometry is {}",
                   gain(study, *nominal));
    if (again != nullptr) text += format(", and after recording again {}", gain(study, *again));
    return Paragraph{.lead = format("Telling {} apart.", merged_names(study)), .text = text + "."};
}

}  // namespace specula
