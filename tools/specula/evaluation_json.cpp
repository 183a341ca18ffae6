#include "tools/specula/evaluation_json.hpp"

#include <nlohmann/json.hpp>

#include "classifier/metrics.hpp"
#include "sim/core/version.hpp"

namespace specula {

namespace {

using Json = nlohmann::ordered_json;

Json interval_json(const Interval& interval) {
    return {{"mean", interval.mean}, {"low_95", interval.low}, {"high_95", interval.high}};
}

Json reliability_json(const Reliability& reliability) {
    Json bins = Json::array();
    for (const ReliabilityBin& bin : reliability.bins)
        bins.push_back({{"n", bin.n}, {"confidence", bin.confidence}, {"accuracy", bin.accuracy}});
    return {{"expected_calibration_error", reliability.expected_calibration_error},
            {"mean_confidence", reliability.mean_confidence},
            {"bins", bins}};
}

Json departure_json(const Departure& departure) {
    Json monitors = Json::object();
    for (std::size_t m = 0; m < departure.monitor.size(); ++m)
        monitors[departure.monitor[m]] = {{"auroc", departure.detection[m].auroc},
                                          {"fpr95", departure.detection[m].fpr95}};
    return {{"monitors", monitors},
            {"population_stability", departure.population_stability},
            {"mean_shift_sd", departure.mean_shift},
            {"mean_discrepancy_squared", departure.mean_discrepancy}};
}

}  // namespace

Json confusion_json(const Confusion& confusion) {
    Json rows = Json::array();
    for (std::size_t truth = 0; truth < confusion.n; ++truth) {
        Json row = Json::array();
        for (std::size_t said = 0; said < confusion.n; ++said)
            row.push_back(confusion.at(truth, said));
        rows.push_back(row);
    }
    return rows;
}

std::string evaluation_json(const EvaluationFacts& facts, const Assessment& assessment,
                            const std::optional<Departure>& departure) {
    Json json{{"format", "specula-evaluation"},
              {"format_version", 1},
              {"software_version", program_version},
              {"model", facts.model},
              {"data", facts.data},
              {"data_fingerprint", facts.fingerprint},
              {"data_is_training_data", facts.is_training_data},
              {"class_names", facts.class_names},
              {"merged_classes", facts.merged},
              {"frames", assessment.n_rows},
              {"sessions", assessment.n_sessions},
              {"worlds", assessment.n_worlds},
              {"worlds_without_some_class", assessment.n_worlds_short_of_classes},
              {"accuracy", assessment.accuracy},
              {"macro_f1_all_frames", macro_f1(assessment.confusion)},
              {"macro_f1", interval_json(assessment.macro_f1)},
              {"macro_f1_merged", interval_json(assessment.macro_f1_merged)}};
    json["recall"] = Json::object();
    for (std::size_t c = 0; c < facts.class_names.size(); ++c)
        json["recall"][facts.class_names[c]] =
            assessment.recall[c] ? Json(*assessment.recall[c]) : Json(nullptr);
    json["confusion_true_by_predicted"] = confusion_json(assessment.confusion);
    json["negative_log_likelihood_nats"] = assessment.negative_log_likelihood;
    json["brier"] = assessment.brier;
    json["reliability"] = reliability_json(assessment.reliability);
    json["temperature"] = facts.temperature;
    json["negative_log_likelihood_scaled_nats"] = assessment.negative_log_likelihood_scaled;
    json["reliability_scaled"] = reliability_json(assessment.reliability_scaled);
    json["area_under_risk_coverage"] = assessment.area_under_risk_coverage;
    json["coverage_at_5_percent_risk"] = assessment.coverage_at_5_percent_risk;
    if (departure) {
        json["nominal"] = facts.nominal;
        json["departure_from_nominal"] = departure_json(*departure);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace specula
