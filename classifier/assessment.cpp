#include "classifier/assessment.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

RiskCoverage risk_coverage_by_doubt(const FeatureTable& rows, const Predictions& predictions) {
    std::vector<double> confidence =
        unfamiliarity(Monitor::softmax_probability, {.rows = rows, .predictions = predictions});
    std::vector<std::uint8_t> wrong;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        confidence[i] = -confidence[i];
        wrong.push_back(predictions.label[i] != rows.label[i]);
    }
    return risk_coverage_of(confidence, wrong);
}

std::size_t worlds_short_of_classes(const FeatureTable& rows) {
    std::map<std::int32_t, std::set<std::uint8_t>> in_world;
    for (std::size_t i = 0; i < rows.size(); ++i) in_world[rows.world[i]].insert(rows.label[i]);
    const std::set<std::uint8_t> all(rows.label.begin(), rows.label.end());
    return static_cast<std::size_t>(std::ranges::count_if(
        in_world, [&](const auto& world) { return world.second.size() < all.size(); }));
}

void add_probability_scores(const FeatureTable& rows, const Predictions& predictions,
                            const Assessing& how, Assessment& result) {
    const ClassRows<float> logits{.values = predictions.logits, .n_classes = predictions.n_classes};
    const ClassProbabilities probabilities = softmax(logits);
    result.negative_log_likelihood = negative_log_likelihood(logits, rows.label);
    result.negative_log_likelihood_scaled =
        negative_log_likelihood(logits, rows.label, how.temperature);
    result.brier = brier_score(probabilities, rows.label);
    result.reliability = reliability_of(probabilities, rows.label);
    result.reliability_scaled = reliability_of(softmax(logits, how.temperature), rows.label);
}

}  // namespace

Assessment assess(const FeatureTable& rows, const Predictions& predictions, const Assessing& how) {
    SPECULA_EXPECT(rows.size() > 0 && predictions.size() == rows.size());
    const SessionTree tree = session_tree_of(rows);
    Assessment result;
    result.n_rows = rows.size();
    result.n_sessions = tree.n_sessions();
    result.n_worlds = tree.worlds.size();
    result.n_worlds_short_of_classes = worlds_short_of_classes(rows);
    result.confusion = confusion_of(rows.label, predictions.label, predictions.n_classes);
    result.recall = recall_per_class(result.confusion);
    std::int64_t n_right = 0;
    for (std::size_t c = 0; c < result.confusion.n; ++c) n_right += result.confusion.at(c, c);
    result.accuracy = static_cast<double>(n_right) / static_cast<double>(rows.size());

    const auto per_session = confusion_per_session(tree, rows, predictions.label);
    result.macro_f1 = bootstrap_sessions(tree, macro_f1_value(per_session), how.resampling);
    result.macro_f1_merged =
        bootstrap_sessions(tree, macro_f1_value(per_session, how.merged_class), how.resampling);
    add_probability_scores(rows, predictions, how, result);
    result.risk_coverage = risk_coverage_by_doubt(rows, predictions);
    result.area_under_risk_coverage = area_under_risk_coverage(result.risk_coverage);
    constexpr double accepted_risk = 0.05;
    result.coverage_at_5_percent_risk = coverage_at_risk(result.risk_coverage, accepted_risk);
    return result;
}

Departure departure_from(const Observed& nominal, const Observed& asked) {
    Departure departure;
    for (std::size_t m = 0; m < monitor_names().size(); ++m) {
        const auto monitor = static_cast<Monitor>(m);
        if (monitor == Monitor::mahalanobis && !(nominal.spread && asked.spread)) continue;
        if (monitor == Monitor::prototypes && !(nominal.prototypes && asked.prototypes)) continue;
        const auto familiar = unfamiliarity(monitor, nominal);
        const auto unfamiliar = unfamiliarity(monitor, asked);
        departure.monitor.push_back(monitor_names()[m]);
        departure.detection.push_back(detection_of({familiar, unfamiliar}));
    }
    const TablePair tables{.familiar = nominal.rows, .asked = asked.rows};
    departure.population_stability = population_stability(tables);
    departure.mean_shift = mean_shift(tables);
    departure.mean_discrepancy = mean_discrepancy(tables);
    return departure;
}

}  // namespace specula
