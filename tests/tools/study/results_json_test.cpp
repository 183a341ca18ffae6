#include "tools/study/results_json.hpp"

#include <nlohmann/json.hpp>

#include "tests/check.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

StudySummary summary_of_one() {
    StudyCondition condition;
    condition.result.name = "height";
    condition.result.title = "Höhe";
    condition.result.confusion = Confusion(2);
    condition.result.confusion.at(0, 1) = 3;
    condition.result.confusion.at(1, 1) = 4;
    condition.result.n_frames = 7;
    condition.result.confidence.correct[24] = 4;
    condition.result.confidence.wrong[10] = 3;
    condition.result.macro_f1_per_world = {0.25};
    condition.result.macro_f1_merged_per_world = {1.0};
    condition.result.macro_f1 = {.mean = 0.25, .low = 0.125, .high = 0.5};
    condition.heights_m = {0.35, 0.55};
    StudySummary summary;
    summary.class_names = {"iron", "wood"};
    summary.merged_classes = {0};
    summary.seed = 18446744073709551615ull;
    summary.command = "specula study x";
    summary.fingerprints = {{"height.h5", "0123456789abcdef"}};
    summary.conditions = {condition};
    return summary;
}

TEST_CASE("results hold what the summary holds, under keys with units", "[study]") {
    const Json json = Json::parse(results_json(summary_of_one()));
    CHECK(json["format"] == "specula-results");
    CHECK(json["format_version"] == 3);
    CHECK(json["seed"] == 18446744073709551615ull);
    CHECK(json["fingerprints"]["height.h5"] == "0123456789abcdef");
    const Json& condition = json["conditions"][0];
    CHECK(condition["title"] == "Höhe");
    CHECK(condition["heights_m"] == Json({0.35, 0.55}));
    CHECK(condition["macro_f1"] == Json({{"mean", 0.25}, {"low_95", 0.125}, {"high_95", 0.5}}));
    CHECK(condition["confusion_true_by_predicted"] == Json({{0, 3}, {0, 4}}));
    CHECK(condition["confidence_histogram"]["bins"] == 25);
    CHECK(condition["confidence_histogram"]["correct"][24] == 4);
    CHECK(condition["paper_macro_f1"].is_null());
    CHECK(condition["recall"] == Json({{"iron", 0.0}, {"wood", 1.0}}));
}

TEST_CASE("where nothing was answered, nothing was answered right", "[study]") {
    StudySummary summary = summary_of_one();
    summary.results.fallback = {{.domain = "height", .answered = {0.0, 0.0, 0.0}},
                                {.domain = "tilt", .accuracy = Interval{0.5, 0.4, 0.6}}};
    const Json fallback = Json::parse(results_json(summary))["fallback"];
    CHECK(fallback[0]["accuracy_of_answered"].is_null());
    CHECK(fallback[1]["accuracy_of_answered"] ==
          Json({{"mean", 0.5}, {"low_95_over_worlds", 0.4}, {"high_95_over_worlds", 0.6}}));
}

TEST_CASE("the published figure stands beside the result where there is one", "[study]") {
    StudySummary summary = summary_of_one();
    summary.conditions[0].paper_macro_f1 = 0.685;
    CHECK(Json::parse(results_json(summary))["conditions"][0]["paper_macro_f1"] == 0.685);
}

TEST_CASE("few predictions have no percentiles, and one number no interval", "[study]") {
    StudySummary summary = summary_of_one();
    PaperPercentile few{.domain = "tilt", .n = 4, .percentile = 0.5};
    summary.results.percentiles = {few, few};
    summary.results.percentiles[1].n = 5;
    HonestyCheck check{.name = "laws", .band = {{0.0, 1.0}}, .n_worlds = 2};
    summary.results.checks = {check, check};
    summary.results.checks[1].is_of_all_worlds_together = true;
    const Json json = Json::parse(results_json(summary));
    CHECK(json["paper_percentiles"][0]["percentile"].is_null());
    CHECK(json["paper_percentiles"][0]["low_90"].is_null());
    CHECK(json["paper_percentiles"][1]["percentile"] == 0.5);
    CHECK(json["honesty_checks"][0]["value"]["low_95_over_worlds"] == 0.0);
    CHECK(json["honesty_checks"][1]["value"]["low_95_over_worlds"].is_null());
    CHECK(json["honesty_checks"][1]["weak_evidence"] == true);
}

TEST_CASE("results end in a line break and read the same twice", "[study]") {
    const std::string text = results_json(summary_of_one());
    CHECK(text.back() == '\n');
    CHECK(text == results_json(summary_of_one()));
}

TEST_CASE("a command that is no UTF-8 costs a letter, not the results", "[study]") {
    StudySummary summary = summary_of_one();
    summary.command = "specula study \xff.toml";
    CHECK(Json::parse(results_json(summary))["command"] == "specula study \xef\xbf\xbd.toml");
}

}  // namespace
}  // namespace specula
