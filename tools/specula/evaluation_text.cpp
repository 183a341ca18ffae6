#include "tools/specula/evaluation_text.hpp"

#include <algorithm>
#include <cstdio>

#include "classifier/metrics.hpp"

namespace specula {

namespace {

void print_share(const char* what, const Interval& share) {
    std::printf("%-34s %6.1f %%   95 %% interval %.1f to %.1f\n", what, 100.0 * share.mean,
                100.0 * share.low, 100.0 * share.high);
}

void print_calibration(const Assessment& assessment, bool has_temperature) {
    std::printf("%-34s %6.1f %%\n", "mean confidence",
                100.0 * assessment.reliability.mean_confidence);
    std::printf("%-34s %6.1f %%", "expected calibration error, 15 bins",
                100.0 * assessment.reliability.expected_calibration_error);
    if (has_temperature)
        std::printf("   after temperature scaling %.1f %%",
                    100.0 * assessment.reliability_scaled.expected_calibration_error);
    std::printf("\n%-34s %8.3f", "negative log-likelihood (nats)",
                assessment.negative_log_likelihood);
    if (has_temperature)
        std::printf(" after temperature scaling %.3f", assessment.negative_log_likelihood_scaled);
    std::printf("\n");
    std::printf("%-34s %8.3f\n", "Brier score", assessment.brier);
    std::printf("%-34s %8.3f\n", "area under risk-coverage", assessment.area_under_risk_coverage);
    std::printf("%-34s %6.1f %%\n", "coverage at 5 % risk",
                100.0 * assessment.coverage_at_5_percent_risk);
}

}  // namespace

void print_confusion(const Confusion& confusion, const std::vector<std::string>& class_names) {
    std::printf("\n%-20s", "true \\ said");
    for (const std::string& name : class_names) std::printf(" %10.10s", name.c_str());
    std::printf("  recognised\n");
    const auto recall = recall_per_class(confusion);
    for (std::size_t t = 0; t < class_names.size(); ++t) {
        if (!recall[t]) continue;
        std::printf("%-20.20s", class_names[t].c_str());
        for (std::size_t p = 0; p < class_names.size(); ++p)
            std::printf(" %10lld", static_cast<long long>(confusion.at(t, p)));
        std::printf("  %7.1f %%\n", 100.0 * *recall[t]);
    }
}

void print_assessment(const Assessment& assessment, const AssessmentNames& names) {
    std::printf("%zu frames: accuracy %.1f %%, macro-F1 %.1f %%\n", assessment.n_rows,
                100.0 * assessment.accuracy, 100.0 * macro_f1(assessment.confusion));
    std::printf("%zu sessions of %zu %s\n\n", assessment.n_sessions, assessment.n_worlds,
                assessment.n_worlds == 1 ? "world" : "worlds");
    print_share("macro-F1, mean over worlds", assessment.macro_f1);
    if (assessment.n_worlds_short_of_classes > 0)
        std::printf(
            "  (%zu of the worlds lack a class here: theirs is over the classes they have, "
            "and the mean\n  compares with no other; macro-F1 over all frames is above)\n",
            assessment.n_worlds_short_of_classes);
    if (!names.merged_label.empty())
        print_share(names.merged_label.c_str(), assessment.macro_f1_merged);
    print_calibration(assessment, names.has_temperature);
    print_confusion(assessment.confusion, names.class_names);
}

void print_departure(const Departure& departure) {
    std::printf("\nAgainst the nominal data:\n%-20s %8s %8s\n", "monitor", "AUROC", "FPR95");
    for (std::size_t m = 0; m < departure.monitor.size(); ++m)
        std::printf("%-20s %7.1f%% %7.1f%%\n", departure.monitor[m].c_str(),
                    100.0 * departure.detection[m].auroc, 100.0 * departure.detection[m].fpr95);
    std::printf(
        "largest stability index of a feature %.3f, largest shift of a mean %.2f standard "
        "deviations,\nmean discrepancy (squared) %.4f\n",
        *std::ranges::max_element(departure.population_stability),
        *std::ranges::max_element(departure.mean_shift), departure.mean_discrepancy);
}

}  // namespace specula
