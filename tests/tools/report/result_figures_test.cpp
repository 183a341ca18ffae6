#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tools/report/curve_figure.hpp"
#include "tools/report/forest_figure.hpp"
#include "tools/report/heat_figure.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/report/result_tables.hpp"

namespace specula {
namespace {

TEST_CASE("a forest names its rows and keeps numbers and bands in its table", "[report]") {
    const Figure figure = forest_figure(
        "forest",
        {.title = "Checks",
         .second_line = "two rows",
         .axis_title = "macro-F1 (%)",
         .series = {"value"},
         .rows = {{.label = "A <row>", .values = {Interval{20, 18, 22}}, .band = {{17, 23}}},
                  {.label = "Another", .values = {Interval{85, 80, 90}}}},
         .reference = 20.0,
         .band_label = "where it must lie"});
    const std::string svg = render_figure(figure).svg;
    for (const std::string_view text : {">A &lt;row><", ">Another<", ">where it must lie<"}) {
        INFO(text);
        CHECK(contains(svg, text));
    }
    CHECK(contains(figure.csv, "A <row>,value,0.2,0.18,0.22,0.17,0.23\n"));
    CHECK(contains(figure.csv, "Another,value,0.85,0.8,0.9,,\n"));
}

TEST_CASE("a heat map writes every share and leaves out what is missing", "[report]") {
    const Figure figure =
        heat_figure("heat", {.title = "Grid",
                             .second_line = "",
                             .column_title = "tilt",
                             .rows = {"up", "down"},
                             .columns = {"0", "5"},
                             .emphasised = {},
                             .panels = {{"left", {{0.25, std::nullopt}, {1.0, 0.0}}},
                                        {"right", {{0.5, 0.75}, {0.1, 0.2}}}}});
    const std::string svg = render_figure(figure).svg;
    for (const std::string_view text : {">25<", ">100<", ">0<", ">75<", ">left<", ">right<"}) {
        INFO(text);
        CHECK(contains(svg, text));
    }
    CHECK(contains(figure.csv, "left,up,0,0.25\n"));
    CHECK_FALSE(contains(figure.csv, "left,up,5,"));
}

TEST_CASE("curves keep their bands in the table", "[report]") {
    const Figure figure = curve_figure("curve", {.title = "Along height",
                                                 .second_line = "",
                                                 .y_title = "macro-F1 (%)",
                                                 .panels = {{.x_title = "height",
                                                             .x_range = {-10, 10},
                                                             .curves = {{.label = "as in the paper",
                                                                         .x = {-10, 10},
                                                                         .y = {20, 40},
                                                                         .low = {10, 30},
                                                                         .high = {30, 50}}},
                                                             .diagonal = true,
                                                             .star = {{0.0, 68.5}}}}});
    const std::string svg = render_figure(figure).svg;
    CHECK(contains(svg, ">as in the paper<"));
    CHECK(contains(figure.csv, "height,as in the paper,-10,0.2,0.1,0.3\n"));
}

TEST_CASE("a failed check is named on the first page", "[report]") {
    StudySummary study;
    study.class_names = {"a", "b"};
    study.results.checks = {
        {.name = "x", .title = "Shuffled", .value = {0.9, 0.8, 1.0}, .band = {{0.4, 0.6}}},
        {.name = "y", .title = "Other", .value = {0.5, 0.4, 0.6}, .band = {{0.4, 0.6}}}};
    study.results.checks[0].passed = false;
    const auto words = plain_words(study);
    REQUIRE(words.size() == 1);
    CHECK(contains(words[0].text, "Of 2 honesty checks with a band, 1 fail: \u201cShuffled\u201d"));
    CHECK(contains(check_tables(study).front().rows[0][4], "FAILED"));
}

TEST_CASE("the report says whether the calibration reached its target", "[report]") {
    CalibrationOutcome outcome;
    outcome.sha256 = "0123456789abcdef";
    CHECK(contains(calibration_words(outcome).text, "Nothing was calibrated"));
    outcome.asked = true;
    outcome.target_macro_f1 = 0.942;
    outcome.trials = {{0.0, 0.997}};
    outcome.matching = CalibrationTrial{-17.5, 0.945};
    const std::string missed = calibration_words(outcome).text;
    CHECK(contains(missed, "No admissible value meets it"));
    CHECK(contains(missed, "-17.5"));
    CHECK(contains(missed, "SHA-256 0123456789abcdef"));
    outcome.reached = true;
    outcome.snr_db = 3.0;
    CHECK(contains(calibration_words(outcome).text, "It is met at +3.0"));
}

}  // namespace
}  // namespace specula
