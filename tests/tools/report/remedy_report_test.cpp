#include "tests/check.hpp"
#include "tests/tools/report/made_up_study.hpp"
#include "tools/report/gain_figure.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/paper_agreement.hpp"
#include "tools/report/reliability_grid.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/report/result_figures.hpp"
#include "tools/report/result_tables.hpp"

// What the report says of remedies, of their price, and of how much it can be believed.

namespace specula {
namespace {

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

DomainScore score_of(const std::string& domain, const Interval& all, const Interval& merged) {
    return {.domain = domain, .all = all, .merged = merged, .per_world = {{0, 0}, {0, 0}}};
}

/// The paper's rung, and a recommended one that gives up five classes for four.
StudySummary with_ladder() {
    StudySummary study = made_up_study();
    LadderRung paper{.name = "paper", .title = "As in the paper"};
    paper.domains = {score_of("nominal", {0.998, 0.99, 1.0}, {0.999, 0.99, 1.0}),
                     score_of("height", {0.11, 0.1, 0.12}, {0.16, 0.1, 0.2})};
    LadderRung best{.name = "best", .title = "Another profile"};
    best.domains = {score_of("nominal", {0.78, 0.77, 0.79}, {0.98, 0.97, 0.99}),
                    score_of("height", {0.76, 0.75, 0.77}, {0.975, 0.96, 0.985})};
    best.confirmed = {score_of("nominal", {0.773, 0.76, 0.784}, {0.979, 0.97, 0.99}),
                      score_of("height", {0.75, 0.74, 0.76}, {0.972, 0.956, 0.991})};
    best.recommended = true;
    best.gain = {{-0.2, -0.3, -0.1}, {0.65, 0.6, 0.7}};
    best.gain_merged = {{-0.02, -0.03, -0.01}, {0.82, 0.8, 0.84}};
    study.results.ladder = {paper, best};
    study.results.choosing_worlds = {0};
    return study;
}

std::string words_under(const StudySummary& study, const std::string& lead) {
    for (const Paragraph& paragraph : plain_words(study))
        if (paragraph.lead == lead) return paragraph.text;
    return "(no such words)";
}

TEST_CASE("the summary gives the price of the remedy and its interval, of unused worlds",
          "[report]") {
    const std::string text = words_under(with_ladder(), "The repair.");
    CAPTURE(text);
    CHECK(has(text, "on 1 of the 2 worlds. The others, which had no say in it, give: 97.2\u00a0%"));
    CHECK(has(text, "interval over worlds 95.6 to 99.1"));
    CHECK(has(text, "all 5 classes apart it scores 77.3\u00a0% (95\u00a0% interval over worlds 76.0 "
                    "to 78.4) on random frames, where the paper\u2019s classifier scores 99.8"));
    CHECK(has(text, "75.0\u00a0% or more in every condition"));
    CHECK(has(text, "iron and aluminium taken for each other"));
    StudySummary kept = with_ladder();
    kept.results.device = DeviceFiles{.model = "models/m.json", .why_no_blob = "no such code"};
    CHECK(has(words_under(kept, "The repair."), "does not run in the firmware: no such code"));
    kept.results.device = DeviceFiles{.model = "models/m.json", .blob = "firmware/m.rfwm"};
    CHECK(has(words_under(kept, "The repair."), "in firmware/m.rfwm, for the firmware"));
    StudySummary one_world = with_ladder();
    one_world.results.ladder[1].confirmed.clear();
    CHECK(has(words_under(one_world, "The repair."), "a selected figure, not a fair one"));
}

TEST_CASE("table and figures of the ladder hold classes apart and merged, in every condition",
          "[report]") {
    const StudySummary study = with_ladder();
    const auto row = remedy_tables(study).front().rows.at(1);
    CHECK(row.at(5) == "78.0");
    CHECK(row.at(6) == "77.0 to 79.0");
    CHECK(row.at(7) == "76.0");
    CHECK(row.at(8) == "97.5");
    CHECK(row.at(9) == "96.0 to 98.5");
    const auto figures = remedy_figures(study);
    REQUIRE(figures.size() == 2);
    CHECK(has(figures[0].figure.csv, "5 classes,Another profile,Random frames,0.78\n"));
    CHECK(has(figures[0].figure.csv, "iron and aluminium merged,Another profile,Height,0.975\n"));
    const std::string& gains = figures[1].figure.csv;
    CHECK(has(gains, "Another profile,Random frames,5 classes,-0.2,-0.3,-0.1\n"));
    CHECK(has(gains, "Another profile,Height,iron and aluminium merged,0.82,0.8,0.84\n"));
}

TEST_CASE("no interval is cut by an axis of the gains", "[report]") {
    const Figure figure = gain_figure(
        "gains", {.title = "Gains",
                  .second_line = "",
                  .series = {"all"},
                  .panels = {"Height", "Tilt"},
                  .rows = {{.label = "A", .values = {{{0.8, 0.75, 0.93}}, {{-0.5, -0.61, 0.0}}}}}});
    CHECK(has(figure.script, "set xrange [0:100]"));
    CHECK(has(figure.script, "set xrange [-70:0]"));
    CHECK(has(render_figure(figure).svg, ">Tilt<"));
}

TEST_CASE("evidence that is weak is called so", "[report]") {
    const HonestyCheck firm{.value = {0.5, 0.48, 0.52}, .band = {{0.4, 0.6}}, .n_worlds = 12};
    HonestyCheck wide = firm, few = firm;
    wide.value = {0.5, 0.3, 0.7};
    few.n_worlds = 2;
    CHECK_FALSE(firm.is_weak());
    CHECK(wide.is_weak());
    CHECK(few.is_weak());
    StudySummary study = made_up_study();
    study.results.checks = {firm, wide, few};
    CHECK(has(words_under(study, "Can this be believed?"), "2 of them pass weakly"));
    CHECK(check_tables(study).front().rows[0][4] == "passed");
    CHECK(check_tables(study).front().rows[1][4] == "passed, weak");
    HonestyCheck single{.value = {1.0, 1.0, 1.0}, .band = {{0.01, 1.0}}, .n_worlds = 2};
    single.is_of_all_worlds_together = true;
    study.results.checks = {firm, single};
    CHECK(has(words_under(study, "Can this be believed?"), "1 of them passes weakly"));
    CHECK(check_tables(study).front().rows[0][2] == "48.0 to 52.0");
    CHECK(check_tables(study).front().rows[1][2] == "\u2013");
    CHECK(check_tables(study).front().rows[1][4] == "passed, weak");
    CHECK(words_under(study, "Weak evidence.") == "(no such words)");
    study.conditions[0].result.macro_f1_per_world.resize(2);
    CHECK(has(words_under(study, "Weak evidence."), "2 worlds only"));
}

TEST_CASE("worlds that all miss the paper lie above it or below it, as they do", "[report]") {
    StudySummary study = made_up_study();
    StudyCondition& condition = study.conditions[0];
    condition.result.macro_f1 = {0.998, 0.997, 0.999};
    condition.result.macro_f1_per_world = {0.997, 0.9975, 0.998, 0.9985, 0.999};
    CHECK(has(agreement_text(study, condition), "Of 5 worlds, 0 lie below"));
    condition.paper_macro_f1 = 0.9999;
    CHECK(has(agreement_text(study, condition), "Of 5 worlds, 5 lie below"));
}

TEST_CASE("the grid says whose worlds it is of, and where the remedy loses", "[report]") {
    StudySummary study = made_up_study();
    SeverityGrid& grid = study.results.severity;
    grid.classifiers = {"As in the paper",
                        "A remedy whose name is much too long for one line over its panel"};
    grid.height_offsets_m = {0.0, 0.05};
    grid.tilts_rad = {0.0};
    grid.n_worlds = 4;
    const std::vector<Interval> both{{0.8, 0.7, 0.9}, {0.7, 0.6, 0.8}};
    for (const auto& [offset, receiver] :
         {std::pair{0.0, ""}, {0.05, ""}, {0.0, "gain +1 dB"}, {0.0, "snr -3 dB"}})
        grid.cells.push_back({.height_offset_m = offset,
                              .receiver = receiver,
                              .all = {0.8, 0.7},
                              .merged = {0.8, 0.9},
                              .intervals = both});
    grid.cells[2].all = {0.6, 0.7};
    const auto figures = severity_figures(study);
    REQUIRE(figures.size() == 3);
    for (const StudyFigure& figure : figures) CHECK(has(figure.caption, "4 worlds"));
    CHECK(has(figures[2].caption, "below \u201cAs in the paper\u201d in 1 of these 2 cells, at every "
                                  "ratio of signal to noise among them"));
    const std::string svg = render_figure(figures[0].figure).svg;
    CHECK_FALSE(has(svg, ">A remedy whose name is much too long for one line over its panel<"));
    CHECK(has(svg, ">A remedy whose name"));
}

TEST_CASE("reliability shows how many frames a bin holds and how sure its share is", "[report]") {
    const Figure figure = reliability_grid(
        "reliability", {.least_confidence = 0.2,
                        .panels = {{.title = "Height",
                                    .points = {{.confidence = 0.5,
                                                .accuracy = {0.25, 0.2, 0.3},
                                                .n = 40}},
                                    .calibration_error = 0.25}}});
    CHECK(has(figure.csv, "Height,40,0.5,0.25,0.2,0.3\n"));
    CHECK(has(render_figure(figure).svg, ">Height (calibration error 25.0\u00a0%)<"));
}

}  // namespace
}  // namespace specula
