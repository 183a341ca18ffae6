#include "tools/study/results_json.hpp"

#include "classifier/metrics.hpp"
#include "tools/study/json_parts.hpp"

namespace specula {

namespace {

using Json = nlohmann::ordered_json;

Json confusion_json(const Confusion& confusion) {
    Json rows = Json::array();
    for (std::size_t truth = 0; truth < confusion.n; ++truth) {
        Json row = Json::array();
        for (std::size_t predicted = 0; predicted < confusion.n; ++predicted)
            row.push_back(confusion.at(truth, predicted));
        rows.push_back(row);
    }
    return rows;
}

Json recall_json(const Confusion& confusion, const std::vector<std::string>& class_names) {
    Json recall = Json::object();
    if (confusion.n != class_names.size()) return recall;
    const auto shares = recall_per_class(confusion);
    for (std::size_t c = 0; c < class_names.size(); ++c)
        recall[class_names[c]] = shares[c] ? Json(*shares[c]) : Json(nullptr);
    return recall;
}

Json condition_json(const StudyCondition& condition, const std::vector<std::string>& class_names) {
    const ConditionReport& result = condition.result;
    Json json{{"name", result.name},
              {"title", result.title},
              {"frames", result.n_frames},
              {"heights_m", condition.heights_m},
              {"macro_f1", interval_json(result.macro_f1)},
              {"macro_f1_merged", interval_json(result.macro_f1_merged)},
              {"recall", recall_json(result.confusion, class_names)},
              {"mean_confidence", world_interval_json(result.mean_confidence)},
              {"macro_f1_per_world", result.macro_f1_per_world},
              {"macro_f1_merged_per_world", result.macro_f1_merged_per_world},
              {"confusion_true_by_predicted", confusion_json(result.confusion)},
              {"confidence_histogram",
               {{"bins", ConfidenceHistogram::n_bins},
                {"correct", result.confidence.correct},
                {"wrong", result.confidence.wrong}}}};
    json["paper_macro_f1"] =
        condition.paper_macro_f1 ? Json(*condition.paper_macro_f1) : Json(nullptr);
    return json;
}

}  // namespace

std::string results_json(const StudySummary& summary) {
    Json json{{"format", "specula-results"},
              {"format_version", 3},
              {"software_version", summary.version},
              {"experiment", summary.experiment},
              {"command", summary.command},
              {"seed", summary.seed},
              {"trainings_per_world", summary.repeats},
              {"class_names", summary.class_names},
              {"merged_classes", summary.merged_classes},
              {"radar",
               {{"name", summary.radar.name},
                {"start_frequency_hz", summary.radar.start_frequency_hz},
                {"slope_hz_per_s", summary.radar.slope_hz_s},
                {"sampled_bandwidth_hz", summary.radar.sampled_bandwidth_hz},
                {"range_bin_m", summary.radar.range_bin_m},
                {"nominal_height_m", summary.radar.nominal_height_m},
                {"nominal_height_bin", summary.radar.nominal_height_bin}}}};
    json["warnings"] = summary.warnings;
    for (const auto& [what, hash] : summary.fingerprints) json["fingerprints"][what] = hash;
    for (const StudyCondition& condition : summary.conditions)
        json["conditions"].push_back(condition_json(condition, summary.class_names));
    for (const StudyCondition& part : summary.parts)
        json["parts_of_conditions"].push_back(condition_json(part, summary.class_names));
    add_results(summary.results, json);
    // A path in the command may be no UTF-8; that shall not cost the results of a night.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace specula
