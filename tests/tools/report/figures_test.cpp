#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/tools/report/made_up_study.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/confidence_figure.hpp"
#include "tools/report/confusion_figure.hpp"
#include "tools/report/f1_figure.hpp"
#include "tools/report/range_profile_figure.hpp"
#include "tools/report/render_figure.hpp"

using namespace specula;

namespace {

ConditionReport two_classes() {
    ConditionReport report;
    report.name = "bench";
    report.title = "On the bench";
    report.confusion = Confusion(2);
    report.confusion.counts = {90, 10, 25, 75};
    report.confidence.correct[24] = 150;
    report.confidence.correct[12] = 15;
    report.confidence.wrong[14] = 35;
    report.macro_f1_per_world = {0.8, 0.85};
    report.macro_f1 = {.mean = 0.825, .low = 0.8, .high = 0.85};
    report.mean_confidence = {.mean = 0.9, .low = 0.88, .high = 0.91};
    return report;
}

F1Rows two_rows() {
    return {.rows = {{"a", "First", {0.9, 0.88, 0.92}, {0.95, 0.94, 0.96}, {0.9}, {0.95}, 0.91},
                     {"b", "Second", {0.1, 0.08, 0.12}, {0.2, 0.1, 0.3}, {0.1}, {0.2}, {}}},
            .n_classes = 5,
            .all_label = "5 classes",
            .merged_label = "merged"};
}

}  // namespace

TEST_CASE("the confusion figure shows its numbers, classes and macro-F1", "[report]") {
    const Figure figure = confusion_figure("confusion", two_classes(), {"iron", "o'hara <b>"});
    const std::string svg = render_figure(figure).svg;
    for (const std::string_view text :
         {">90.0\u00a0%<", ">10.0\u00a0%<", ">25.0\u00a0%<", ">75.0\u00a0%<", ">90<", ">25<",
          ">iron<", ">o'hara &lt;b>", "macro-F1 82.5\u00a0%", "80.0 to 85.0\u00a0%", "2 worlds"})
        CHECK(contains(svg, text));
    CHECK(contains(figure.csv,
                   "condition,true_class,predicted_class,n_frames,share_of_true_class\n"));
    CHECK(contains(figure.csv, "bench,o'hara <b>,iron,25,0.25\n"));
}

TEST_CASE("a class without frames does not divide by zero", "[report]") {
    ConditionReport report = two_classes();
    report.confusion.counts = {0, 0, 25, 75};
    const Figure figure = confusion_figure("confusion", report, {"iron", "wood"});
    CHECK(contains(figure.csv, "bench,iron,iron,0,0\n"));
    CHECK_FALSE(contains(figure.script, "nan"));
}

TEST_CASE("correct and wrong frames are counted apart, each to 100 %", "[report]") {
    const Figure figure = confidence_figure("confidence", two_classes());
    CHECK(contains(figure.csv, "bench,0.96,1,150,0,0.9090909090909091,0\n"));
    CHECK(contains(figure.csv, "bench,0.56,0.6,0,35,0,1\n"));
    const std::string svg = render_figure(figure).svg;
    CHECK(contains(svg, "correct: 82.5\u00a0% of frames (165)"));
    CHECK(contains(svg, "wrong: 17.5\u00a0% of frames (35)"));
}

TEST_CASE("a condition without wrong frames can be drawn", "[report]") {
    ConditionReport report = two_classes();
    report.confidence.wrong = {};
    CHECK(contains(render_figure(confidence_figure("c", report)).svg,
                   "wrong: 0.0\u00a0% of frames (0)"));
}

TEST_CASE("macro-F1 is tabulated by world, and the paper beside it", "[report]") {
    const Figure figure = f1_figure("macro_f1", two_rows());
    CHECK(contains(figure.csv, "a,5 classes,mean,,0.9,0.88,0.92\n"));
    CHECK(contains(figure.csv, "b,merged,world,0,0.2,,\n"));
    CHECK(contains(figure.csv, "a,5 classes,paper,,0.91,,\n"));
    const std::string svg = render_figure(figure).svg;
    for (const std::string_view text : {">First<", ">Second<", "chance, 5 classes", ">the paper<"})
        CHECK(contains(svg, text));
}

TEST_CASE("profiles keep their bin numbers", "[report]") {
    const Figure figure =
        range_profile_figure("profile", {.panels = {{"a", "First", {{{1, 5, 2}, {0.1, 0.5, 0.2}}}}},
                                         .class_names = {"iron"},
                                         .first_bin = 6,
                                         .quantity = "magnitude",
                                         .marked_bin = 7.2});
    CHECK(contains(figure.csv, "a,iron,7,5,0.5\n"));
    CHECK(contains(render_figure(figure).svg, ">First<"));
}

TEST_CASE("the same figure gives the same SVG and PNG", "[report]") {
    const Figure figure = f1_figure("macro_f1", two_rows());
    const Drawing one = render_figure(figure), two = render_figure(figure);
    CHECK(one.svg == two.svg);
    CHECK(one.png == two.png);
    CHECK(one.png.starts_with("\x89PNG"));
}

TEST_CASE("an error names the figure", "[report]") {
    Figure figure = f1_figure("macro_f1", two_rows());
    figure.script = "plot nonsense(x)\n";
    std::string message;
    try {
        render_figure(figure);
    } catch (const SystemError& error) {
        message = error.what();
    }
    CHECK(message.starts_with("figure macro_f1: gnuplot"));
}

TEST_CASE("long titles are broken at spaces, and no word is lost", "[report]") {
    const std::string title = "Sample tilted -10 and +10 degrees about its centre";
    const auto lines = wrapped(title, 200, true);
    CHECK(lines.size() == 2);
    CHECK(lines[0] + " " + lines[1] == title);
    CHECK(wrapped("short", 200) == std::vector<std::string>{"short"});
    CHECK(wrapped("unbreakablyLongWord", 10) == std::vector<std::string>{"unbreakablyLongWord"});
}
