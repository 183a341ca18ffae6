#include <algorithm>
#include <cmath>

#include "classifier/class_probabilities.hpp"
#include "classifier/detection.hpp"
#include "classifier/drift.hpp"
#include "classifier/metrics.hpp"
#include "classifier/risk_coverage.hpp"
#include "classifier/unfamiliarity.hpp"
#include "firmware/fw_monitor.h"
#include "sim/parallel.hpp"
#include "tools/report/study_summary.hpp"
#include "tools/study/attribution.hpp"

/// What could warn of a shift, and how far confidence can be believed.
namespace specula {

namespace {

constexpr std::size_t n_monitors = 5;
constexpr std::size_t curve_points = 100;

/// (monitor) -> scores (frame).
using Scores = std::array<std::vector<double>, n_monitors>;

Scores scores_of_world(const Model& model, const Prototypes& prototypes, const FeatureTable& rows,
                       const WorldOutcome& outcome) {
    const Observed observed{.rows = rows,
                            .predictions = outcome.predictions,
                            .spread = model.monitor ? &*model.monitor : nullptr,
                            .prototypes = &prototypes};
    Scores scores;
    for (std::size_t i = 0; i < n_monitors; ++i) {
        const auto monitor = static_cast<Monitor>(i);
        if (monitor == Monitor::mahalanobis && !model.monitor) continue;
        scores[i] = unfamiliarity(monitor, observed);
    }
    return scores;
}

/// Domain by domain and world by world.
std::vector<std::vector<Scores>> all_scores(const StudyContext& context,
                                            const MonitoredModels& baseline,
                                            const std::vector<JudgedDomain>& domains) {
    const std::size_t worlds = baseline.models.size();
    std::vector<std::vector<Scores>> scores(domains.size(), std::vector<Scores>(worlds));
    const auto score = [&](std::size_t world) {
        const Prototypes prototypes = prototypes_of(*baseline.models[world].prototypes);
        for (std::size_t domain = 0; domain < domains.size(); ++domain)
            scores[domain][world] =
                scores_of_world(baseline.models[world], prototypes, domains[domain].rows[world],
                                domains[domain].outcomes[world]);
    };
    for_each_index(worlds, context.run.threads, score);
    return scores;
}

void add_detectors(const StudyContext& context, const std::vector<JudgedDomain>& domains,
                   const std::vector<std::vector<Scores>>& scores, StudyResults& results) {
    const auto null = std::ranges::find_if(
        domains, [](const JudgedDomain& d) { return d.name == rerecorded_condition; });
    if (null == domains.end()) return;
    const auto& familiar = scores[static_cast<std::size_t>(null - domains.begin())];
    for (std::size_t monitor = 0; monitor < n_monitors; ++monitor)
        for (std::size_t domain = 0; domain < domains.size(); ++domain) {
            const std::string& name = domains[domain].name;
            if (name == nominal_condition || name == rerecorded_condition) continue;
            std::vector<double> auroc, fpr95;
            for (std::size_t world = 0; world < familiar.size(); ++world) {
                const auto& known = familiar[world][monitor];
                const auto& asked = scores[domain][world][monitor];
                if (known.empty() || asked.empty()) continue;
                const Detection detection = detection_of({known, asked});
                auroc.push_back(detection.auroc);
                fpr95.push_back(detection.fpr95);
            }
            if (auroc.empty()) continue;
            results.detectors.push_back({monitor_names()[monitor], name,
                                         bootstrap_mean(auroc, context.bootstrap()),
                                         bootstrap_mean(fpr95, context.bootstrap())});
        }
}

/// Frames beyond the monitor's own limit get no answer.
void add_fallback(const StudyContext& context, const MonitoredModels& baseline,
                  const std::vector<JudgedDomain>& domains,
                  const std::vector<std::vector<Scores>>& scores, StudyResults& results) {
    constexpr auto distance = static_cast<std::size_t>(Monitor::mahalanobis);
    for (std::size_t domain = 0; domain < domains.size(); ++domain) {
        std::vector<double> answered, accuracy, accuracy_all;
        for (std::size_t world = 0; world < baseline.models.size(); ++world) {
            const auto& own = scores[domain][world][distance];
            if (own.empty()) continue;
            const WorldOutcome& outcome = domains[domain].outcomes[world];
            const double limit =
                static_cast<double>(baseline.models[world].monitor->suspicious_squared);
            double n = 0.0, n_right = 0.0, all_right = 0.0;
            for (std::size_t i = 0; i < own.size(); ++i) {
                const bool right = outcome.truth[i] == outcome.predictions.label[i];
                all_right += right;
                if (own[i] > limit) continue;
                n += 1.0;
                n_right += right;
            }
            answered.push_back(n / static_cast<double>(own.size()));
            accuracy_all.push_back(all_right / static_cast<double>(own.size()));
            if (n > 0.0) accuracy.push_back(n_right / n);
        }
        if (answered.empty()) continue;
        FallbackScore score{.domain = domains[domain].name,
                            .answered = bootstrap_mean(answered, context.bootstrap()),
                            .accuracy = {},
                            .accuracy_all = bootstrap_mean(accuracy_all, context.bootstrap())};
        if (!accuracy.empty()) score.accuracy = bootstrap_mean(accuracy, context.bootstrap());
        results.fallback.push_back(std::move(score));
    }
}

/// All worlds' frames of a domain, as one list.
struct Pooled {
    std::vector<float> logits;
    std::vector<std::uint8_t> truth, wrong;
    std::vector<double> confidence;
    std::size_t n_classes = 0;
};

Pooled pooled(const std::vector<WorldOutcome>& outcomes) {
    Pooled all;
    for (const WorldOutcome& world : outcomes) {
        const Predictions& said = world.predictions;
        all.n_classes = said.n_classes;
        all.logits.insert(all.logits.end(), said.logits.begin(), said.logits.end());
        all.truth.insert(all.truth.end(), world.truth.begin(), world.truth.end());
        for (std::size_t i = 0; i < world.truth.size(); ++i) {
            all.wrong.push_back(world.truth[i] != said.label[i]);
            all.confidence.push_back(static_cast<double>(said.probability[i]));
        }
    }
    return all;
}

/// Bins of all worlds together; how far each can be trusted follows from the worlds' own.
std::vector<ReliabilityPoint> reliability_points(const StudyContext& context,
                                                 const JudgedDomain& domain,
                                                 const Reliability& together) {
    std::vector<Reliability> worlds;
    for (const WorldOutcome& world : domain.outcomes)
        worlds.push_back(
            reliability_of(softmax(ClassRows<float>{world.predictions.logits,
                                                    world.predictions.n_classes}),
                           world.truth, static_cast<int>(together.bins.size())));
    std::vector<ReliabilityPoint> points;
    for (std::size_t bin = 0; bin < together.bins.size(); ++bin) {
        const ReliabilityBin& all = together.bins[bin];
        if (all.n == 0) continue;
        std::vector<double> right, n;
        for (const Reliability& world : worlds) {
            n.push_back(static_cast<double>(world.bins[bin].n));
            right.push_back(world.bins[bin].accuracy * n.back());
        }
        points.push_back({.confidence = all.confidence,
                          .accuracy = bootstrap_share(right, n, context.bootstrap()),
                          .n = all.n});
    }
    return points;
}

ConfidenceQuality quality_of(const StudyContext& context, const JudgedDomain& domain,
                             double temperature) {
    const Pooled all = pooled(domain.outcomes);
    const ClassRows<float> logits{all.logits, all.n_classes};
    const ClassProbabilities raw = softmax(logits);
    const Reliability reliability = reliability_of(raw, all.truth);
    const RiskCoverage curve = risk_coverage_of(all.confidence, all.wrong);
    ConfidenceQuality quality{
        .domain = domain.name,
        .ece = reliability.expected_calibration_error,
        .ece_scaled =
            reliability_of(softmax(logits, temperature), all.truth).expected_calibration_error,
        .nll = negative_log_likelihood(logits, all.truth),
        .brier = brier_score(raw, all.truth),
        .aurc = area_under_risk_coverage(curve),
        .coverage_at_5_percent = coverage_at_risk(curve, 0.05)};
    quality.reliability = reliability_points(context, domain, reliability);
    for (std::size_t i = 0; i < curve_points; ++i) {
        const std::size_t k = std::max<std::size_t>(1, (i + 1) * curve.risk.size() / curve_points);
        quality.risk.push_back({curve.coverage(k - 1), curve.risk[k - 1]});
    }
    return quality;
}

InputDrift drift_of(const StudyContext& context, const WorldRows& training,
                    const JudgedDomain& domain) {
    const std::size_t worlds = training.size();
    std::vector<double> psi(worlds), discrepancy(worlds), shift(worlds);
    std::vector<std::vector<double>> per_feature(worlds);
    const auto mean_of = [](const std::vector<double>& values) {
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    const auto measure = [&](std::size_t world) {
        const TablePair tables{training[world], domain.rows[world]};
        per_feature[world] = population_stability(tables);
        psi[world] = mean_of(per_feature[world]);
        discrepancy[world] = mean_discrepancy(tables, {.max_rows = 300});
        shift[world] = mean_of(mean_shift(tables));
    };
    for_each_index(worlds, context.run.threads, measure);
    InputDrift drift{.domain = domain.name,
                     .psi = bootstrap_mean(psi, context.bootstrap()),
                     .discrepancy = bootstrap_mean(discrepancy, context.bootstrap()),
                     .mean_shift = bootstrap_mean(shift, context.bootstrap()),
                     .psi_per_feature = std::vector<double>(per_feature.front().size(), 0.0)};
    for (const auto& world : per_feature)
        for (std::size_t k = 0; k < world.size(); ++k)
            drift.psi_per_feature[k] += world[k] / static_cast<double>(worlds);
    return drift;
}

}  // namespace

void judge_monitors(const StudyContext& context, const MonitoredModels& baseline,
                    const std::vector<JudgedDomain>& domains, StudyResults& results) {
    const auto scores = all_scores(context, baseline, domains);
    add_detectors(context, domains, scores, results);
    add_fallback(context, baseline, domains, scores, results);
    const Pooled nominal = pooled(domains.front().outcomes);
    results.temperature =
        fit_temperature(ClassRows<float>{nominal.logits, nominal.n_classes}, nominal.truth);
    for (const JudgedDomain& domain : domains) {
        results.confidence.push_back(quality_of(context, domain, results.temperature));
        results.drift.push_back(drift_of(context, baseline.training, domain));
    }
}

}  // namespace specula
