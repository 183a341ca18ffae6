#include "classifier/evaluate.hpp"

#include <algorithm>

#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

void add(const Confusion& from, Confusion& to) {
    SPECULA_EXPECT(from.n == to.n);
    for (std::size_t i = 0; i < from.counts.size(); ++i) to.counts[i] += from.counts[i];
}

std::size_t confidence_bin(float probability) {
    constexpr std::size_t n = ConfidenceHistogram::n_bins;
    const double scaled = static_cast<double>(probability) * static_cast<double>(n);
    return std::min(static_cast<std::size_t>(scaled), n - 1);  // 1 belongs to the last bin
}

void count_confidence(const WorldOutcome& world, ConfidenceHistogram& histogram) {
    for (std::size_t i = 0; i < world.truth.size(); ++i) {
        const bool correct = world.truth[i] == world.predictions.label[i];
        auto& bins = correct ? histogram.correct : histogram.wrong;
        ++bins[confidence_bin(world.predictions.probability[i])];
    }
}

double mean_confidence(const WorldOutcome& world) {
    double sum = 0.0;
    for (const float probability : world.predictions.probability)
        sum += static_cast<double>(probability);
    return sum / static_cast<double>(world.predictions.size());
}

}  // namespace

ConditionReport evaluate(const std::string& name, const std::string& title,
                         std::span<const WorldOutcome> worlds, const Scoring& scoring) {
    SPECULA_EXPECT(!worlds.empty());
    ConditionReport report;
    report.name = name;
    report.title = title;
    report.confusion = Confusion(worlds.front().predictions.n_classes);
    std::vector<double> confidence_per_world;
    for (const WorldOutcome& world : worlds) {
        SPECULA_EXPECT(!world.truth.empty() && world.truth.size() == world.predictions.size());
        const Confusion confusion =
            confusion_of(world.truth, world.predictions.label, world.predictions.n_classes);
        add(confusion, report.confusion);
        count_confidence(world, report.confidence);
        report.n_frames += static_cast<std::int64_t>(world.truth.size());
        report.macro_f1_per_world.push_back(macro_f1(confusion));
        report.macro_f1_merged_per_world.push_back(
            macro_f1(merge_classes(confusion, scoring.merged_class)));
        confidence_per_world.push_back(mean_confidence(world));
    }
    report.macro_f1 = bootstrap_mean(report.macro_f1_per_world, scoring.bootstrap);
    report.macro_f1_merged = bootstrap_mean(report.macro_f1_merged_per_world, scoring.bootstrap);
    report.mean_confidence = bootstrap_mean(confidence_per_world, scoring.bootstrap);
    return report;
}

}  // namespace specula
