#include "tools/study/json_parts.hpp"

namespace specula {

namespace {

using Json = nlohmann::ordered_json;

Json domain_json(const DomainScore& score) {
    return {{"domain", score.domain},
            {"macro_f1", world_interval_json(score.all)},
            {"macro_f1_merged", world_interval_json(score.merged)},
            {"macro_f1_per_world", score.per_world.all},
            {"macro_f1_merged_per_world", score.per_world.merged}};
}

Json domains_json(const std::vector<DomainScore>& scores) {
    Json list = Json::array();
    for (const DomainScore& score : scores) list.push_back(domain_json(score));
    return list;
}

Json intervals_json(const std::vector<Interval>& intervals) {
    Json list = Json::array();
    for (const Interval& interval : intervals) list.push_back(world_interval_json(interval));
    return list;
}

Json calibration_json(const CalibrationOutcome& outcome) {
    Json json{{"frozen_file_sha256", outcome.sha256}, {"snr_db", outcome.snr_db}};
    if (!outcome.asked) return json;
    json["target_macro_f1"] = outcome.target_macro_f1;
    json["tolerance"] = outcome.tolerance;
    json["admissible_snr_db"] = outcome.admissible_snr_db;
    json["reached_by_an_admissible_value"] = outcome.reached;
    for (const CalibrationTrial& trial : outcome.trials)
        json["trials"].push_back({{"snr_db", trial.snr_db}, {"macro_f1", trial.macro_f1}});
    json["matching"] = outcome.matching ? Json{{"snr_db", outcome.matching->snr_db},
                                               {"macro_f1", outcome.matching->macro_f1}}
                                        : Json(nullptr);
    return json;
}

void add_attribution(const StudyResults& results, Json& json) {
    for (const WaterfallStep& step : results.waterfall)
        json["waterfall"].push_back(
            {{"step", step.title},
             {"macro_f1", interval_json(step.all)},
             {"macro_f1_merged", interval_json(step.merged)},
             {"loss", step.loss ? world_interval_json(*step.loss) : Json(nullptr)}});
    for (const SensitivityRow& row : results.sensitivity)
        json["sensitivity"].push_back({{"assumption", row.name},
                                       {"title", row.title},
                                       {"fingerprint", row.fingerprint},
                                       {"domains", domains_json(row.domains)}});
    for (const PriorDraw& draw : results.prior.draws)
        json["prior_draws"].push_back({{"assumptions", draw.what},
                                       {"macro_f1_nominal", draw.nominal},
                                       {"macro_f1_domains", draw.domains},
                                       {"accepted", draw.accepted}});
    for (const PaperPercentile& entry : results.percentiles) {
        const auto told = [&](double value) {
            return entry.has_percentiles() ? Json(value) : Json(nullptr);
        };
        json["paper_percentiles"].push_back({{"domain", entry.domain},
                                             {"over", entry.over},
                                             {"paper_macro_f1", entry.paper},
                                             {"n", entry.n},
                                             {"percentile", told(entry.percentile)},
                                             {"median", entry.prediction.mean},
                                             {"low_90", told(entry.prediction.low)},
                                             {"high_90", told(entry.prediction.high)}});
    }
}

/// The ends are null where there is no interval.
Json check_value_json(const HonestyCheck& check) {
    Json value = world_interval_json(check.value);
    if (!check.has_interval()) value["low_95_over_worlds"] = value["high_95_over_worlds"] = nullptr;
    return value;
}

void add_checks(const StudyResults& results, Json& json) {
    for (const HonestyCheck& check : results.checks) {
        Json entry{{"check", check.name},
                   {"title", check.title},
                   {"value", check_value_json(check)},
                   {"band", check.band ? Json(*check.band) : Json(nullptr)}};
        entry["passed"] = check.band ? Json(check.passed) : Json(nullptr);
        entry["worlds"] = check.n_worlds;
        entry["weak_evidence"] = check.band ? Json(check.is_weak()) : Json(nullptr);
        entry["reason"] = check.reason;
        json["honesty_checks"].push_back(entry);
    }
}

void add_ladder(const StudyResults& results, Json& json) {
    if (!results.ladder.empty())
        json["recommendation"] = {{"chosen_on_worlds", results.choosing_worlds},
                                  {"rule", "best worst condition, classes merged; of equals within "
                                           "0.005 the cheapest"}};
    for (const LadderRung& rung : results.ladder)
        json["ladder"].push_back({{"rung", rung.name},
                                  {"title", rung.title},
                                  {"training", rung.training},
                                  {"descriptor", rung.descriptor},
                                  {"rows_and_steps_over_baseline", rung.budget},
                                  {"features", rung.cost.n_features},
                                  {"multiplications", rung.cost.multiplications},
                                  {"model_bytes", rung.cost.model_bytes},
                                  {"estimated_us", {rung.cost.low_us, rung.cost.high_us}},
                                  {"recommended", rung.recommended},
                                  {"domains", domains_json(rung.domains)},
                                  {"domains_on_other_worlds", domains_json(rung.confirmed)},
                                  {"gain_over_baseline", intervals_json(rung.gain)},
                                  {"gain_over_baseline_merged", intervals_json(rung.gain_merged)}});
}

void add_device(const StudyResults& results, Json& json) {
    if (!results.device) return;
    const DeviceFiles& files = *results.device;
    const auto text = [](const std::string& value) {
        return value.empty() ? Json(nullptr) : Json(value);
    };
    json["recommendation"]["model"] = files.model;
    json["recommendation"]["blob"] = text(files.blob);
    json["recommendation"]["why_no_blob"] = text(files.why_no_blob);
}

void add_severity(const SeverityGrid& grid, Json& json) {
    if (grid.cells.empty()) return;
    Json cells = Json::array();
    for (const SeverityCell& cell : grid.cells)
        cells.push_back({{"height_offset_m", cell.height_offset_m},
                         {"tilt_rad", cell.tilt_rad},
                         {"receiver", cell.receiver},
                         {"macro_f1", intervals_json(cell.intervals)},
                         {"macro_f1_merged", cell.merged}});
    json["severity_grid"] = {{"classifiers", grid.classifiers},
                             {"worlds", grid.n_worlds},
                             {"mean_macro_f1", grid.mean_all},
                             {"mean_macro_f1_merged", grid.mean_merged},
                             {"error_over_the_baselines", grid.relative_error},
                             {"cells", cells}};
}

Json reliability_json(const std::vector<ReliabilityPoint>& points) {
    Json bins = Json::array();
    for (const ReliabilityPoint& point : points)
        bins.push_back({{"n", point.n},
                        {"confidence", point.confidence},
                        {"accuracy", world_interval_json(point.accuracy)}});
    return bins;
}

void add_monitors(const StudyResults& results, Json& json) {
    for (const DetectorScore& score : results.detectors)
        json["detectors"].push_back({{"detector", score.detector},
                                     {"domain", score.domain},
                                     {"auroc", world_interval_json(score.auroc)},
                                     {"fpr95", world_interval_json(score.fpr95)}});
    for (const FallbackScore& score : results.fallback)
        json["fallback"].push_back({{"domain", score.domain},
                                    {"answered", world_interval_json(score.answered)},
                                    {"accuracy_of_answered",
                                     score.accuracy ? world_interval_json(*score.accuracy)
                                                    : Json(nullptr)},
                                    {"accuracy_of_all", world_interval_json(score.accuracy_all)}});
    if (!results.confidence.empty()) json["temperature"] = results.temperature;
    for (const ConfidenceQuality& quality : results.confidence)
        json["confidence"].push_back(
            {{"domain", quality.domain},
             {"ece", quality.ece},
             {"ece_with_temperature", quality.ece_scaled},
             {"nll_nats", quality.nll},
             {"brier", quality.brier},
             {"reliability_bins", reliability_json(quality.reliability)},
             {"aurc", quality.aurc},
             {"coverage_at_5_percent_risk", quality.coverage_at_5_percent}});
    for (const InputDrift& drift : results.drift)
        json["drift"].push_back({{"domain", drift.domain},
                                 {"psi", world_interval_json(drift.psi)},
                                 {"mmd_squared", world_interval_json(drift.discrepancy)},
                                 {"mean_shift_sd_of_training", world_interval_json(drift.mean_shift)},
                                 {"psi_per_feature", drift.psi_per_feature}});
}

}  // namespace

Json interval_json(const Interval& interval) {
    return {{"mean", interval.mean}, {"low_95", interval.low}, {"high_95", interval.high}};
}

Json world_interval_json(const Interval& interval) {
    return {{"mean", interval.mean},
            {"low_95_over_worlds", interval.low},
            {"high_95_over_worlds", interval.high}};
}

void add_results(const StudyResults& results, Json& json) {
    json["calibration"] = calibration_json(results.calibration);
    add_attribution(results, json);
    add_checks(results, json);
    add_ladder(results, json);
    add_device(results, json);
    add_severity(results.severity, json);
    add_monitors(results, json);
}

}  // namespace specula
