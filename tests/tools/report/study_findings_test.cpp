#include "tools/report/study_findings.hpp"

#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/tools/report/made_up_study.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/paper_agreement.hpp"
#include "tools/report/result_figures.hpp"
#include "tools/report/result_tables.hpp"

using namespace specula;

namespace {

/// Worlds at mean -+ 2 points; the interval is -+ 1 point.
StudyCondition& with_f1(StudyCondition& condition, double mean, std::optional<double> paper) {
    condition.result.macro_f1_per_world = {mean - 0.02, mean, mean + 0.02, mean, mean};
    condition.result.macro_f1 = {.mean = mean, .low = mean - 0.01, .high = mean + 0.01};
    condition.paper_macro_f1 = paper;
    return condition;
}

StudySummary five_worlds() {
    StudySummary study = made_up_study();
    for (StudyCondition& condition : study.conditions)
        with_f1(condition, condition.result.macro_f1.mean, condition.paper_macro_f1)
            .result.macro_f1_merged_per_world.resize(5);
    return study;
}

std::string tilt_words(const StudySummary& study) {
    for (const Paragraph& paragraph : plain_words(study))
        if (contains(paragraph.lead, "tilt figure")) return paragraph.text;
    return "(no such words)";
}

}  // namespace

TEST_CASE("agreement has three grades, and none without a number", "[report]") {
    StudyCondition c;
    CHECK(paper_agreement(with_f1(c, 0.90, {})) == Agreement::unknown);
    CHECK(paper_agreement(with_f1(c, 0.90, 0.905)) == Agreement::within_interval);
    CHECK(paper_agreement(with_f1(c, 0.90, 0.885)) == Agreement::within_worlds);
    CHECK(paper_agreement(with_f1(c, 0.90, 0.95)) == Agreement::outside);
    // Inside the interval of the mean, but no world is there.
    with_f1(c, 0.90, 0.895).result.macro_f1_per_world = {0.90, 0.90, 0.90, 0.90, 0.90};
    CHECK(paper_agreement(c) == Agreement::outside);
    c.result.macro_f1_per_world.resize(4, 0.90);
    CHECK(paper_agreement(c) == Agreement::too_few);
}

TEST_CASE("verdict, sentence and table place the paper's tilt figure alike", "[report]") {
    StudySummary study = five_worlds();
    for (const double mean : {0.66, 0.68, 0.69, 0.72}) {
        const StudyCondition& tilt = with_f1(study.conditions[3], mean, 0.685);
        study.results.percentiles = {percentile_of(0.685, tilt.result.macro_f1_per_world)};
        const bool agrees = study.results.percentiles[0].agrees();
        CHECK(agrees == (mean == 0.68 || mean == 0.69));
        CHECK(contains(tilt_finding(study)->lead, "agrees with") == agrees);
        CHECK(contains(tilt_finding(study)->text, "within the 5th to 95th") == agrees);
        CHECK(contains(tilt_words(study), "which agrees with them") == agrees);
        CHECK(attribution_tables(study)[0].rows[0][4] ==
              range_number(study.results.percentiles[0].prediction));
    }
}

TEST_CASE("two worlds neither agree with the paper's tilt figure nor have percentiles",
          "[report]") {
    StudySummary study = made_up_study();
    ConditionReport& result = study.conditions[3].result;
    result.macro_f1_per_world = {0.718, 0.720};
    result.macro_f1 = {.mean = 0.719, .low = 0.68, .high = 0.75};  // sessions are resampled too
    for (std::size_t i = 0; i < study.conditions.size(); ++i)
        study.conditions[i].result.macro_f1_per_world.resize(2);
    study.results.percentiles = {percentile_of(0.685, result.macro_f1_per_world)};
    const Paragraph finding = *tilt_finding(study);
    CHECK(contains(finding.lead, "too few worlds"));
    CHECK(contains(finding.text, "fewer than 5 worlds are too few to say whether they agree"));
    CHECK_FALSE(contains(finding.lead + finding.text, "agrees with the paper"));
    CHECK(contains(tilt_words(study), "too few to say where the paper\u2019s 68.5"));
    CHECK(attribution_tables(study)[0].rows[0][4] == "\u2013");
    CHECK(attribution_tables(study)[0].rows[0][6] == "\u2013");
}

TEST_CASE("outside the interval the page says by how much and on which side", "[report]") {
    StudySummary study = five_worlds();
    with_f1(study.conditions[0], 0.90, 0.942);
    CHECK(contains(nominal_finding(study)->lead, "differs from the paper"));
    CHECK(contains(nominal_finding(study)->text, "simulated mean is 4.2\u00a0points lower"));
    with_f1(study.conditions[0], 0.96, 0.942);
    CHECK(contains(nominal_finding(study)->text, "simulated mean is 1.8\u00a0points higher"));
}

TEST_CASE("agreement that was arranged is called so", "[report]") {
    StudySummary study = made_up_study();
    study.calibration = Calibration{"nominal", "the noise level"};
    CHECK(contains(nominal_finding(study)->lead, "set to meet the paper"));
    CHECK(contains(nominal_finding(study)->text, "no evidence: the noise level was set"));
}

TEST_CASE("the loss under tilt is split at the re-recorded condition", "[report]") {
    StudySummary study = five_worlds();
    with_f1(study.conditions[0], 0.95, {});
    with_f1(study.conditions[1], 0.80, {});
    with_f1(study.conditions[3], 0.70, {});
    const std::string text = tilt_finding(study)->text;
    CHECK(contains(text,
                   "of the 25.0\u00a0points between nominal and this condition, 15.0\u00a0points "
                   "(60.0\u00a0%)"));
    CHECK(contains(text, "10.0\u00a0points are due to the tilt itself"));
}

TEST_CASE("where tilt costs nothing the page does not say it does", "[report]") {
    StudySummary study = five_worlds();
    with_f1(study.conditions[1], 0.80, {});
    with_f1(study.conditions[3], 0.80, {}).result.macro_f1_per_world = {0.79, 0.79, 0.81, 0.81, 0.8};
    const std::string text = tilt_finding(study)->text;
    CHECK(contains(text, "show no effect of the tilt itself"));
    CHECK_FALSE(contains(text, "due to the tilt"));
}

TEST_CASE("the move of the echo is counted in range bins", "[report]") {
    const std::string text = height_finding(made_up_study())->text;
    CHECK(contains(text, "35.0\u00a0cm and 55.0\u00a0cm instead of 45.0\u00a0cm"));
    CHECK(contains(text, "a range bin is 3.75\u00a0cm"));
    CHECK(contains(text, "moves by \u22122.7 and +2.7 bins, from bin 12.0 to bins 9.3 and 14.7"));
    CHECK(contains(text, "are called limestone"));
}

TEST_CASE("confidence under height is reported in the direction it took", "[report]") {
    StudySummary study = made_up_study();
    CHECK(contains(confidence_finding(study)->text, "would not notice this shift"));
    study.conditions[2].result.mean_confidence = {.mean = 0.5, .low = 0.48, .high = 0.52};
    const std::string text = confidence_finding(study)->text;
    CHECK_FALSE(contains(text, "would not notice"));
    CHECK(contains(text,
                   "at other heights of the radar is 50.0\u00a0%, 44.1\u00a0points below nominal"));
}

TEST_CASE("a study of one condition in one world still has a page of findings", "[report]") {
    StudySummary study = made_up_study();
    study.conditions.resize(1);
    study.conditions[0].result.macro_f1_per_world = {0.9};
    study.conditions[0].result.macro_f1_merged_per_world = {0.95};
    const auto findings = study_findings(study);
    CHECK(findings.size() == 3);  // nominal, merged classes, confidence
    for (const Paragraph& finding : findings) CHECK_FALSE(finding.text.empty());
}
