#include "tools/report/svg.hpp"

#include <algorithm>
#include <set>

#include "tests/check.hpp"
#include "tests/tools/report/made_up_study.hpp"
#include "tools/report/confusion_figure.hpp"
#include "tools/report/markup_walk.hpp"
#include "tools/report/range_profile_figure.hpp"
#include "tools/report/render_figure.hpp"

using namespace specula;

namespace {

std::string profile_svg() {
    const ClassProfile profile{.mean = {1, 5, 2}, .sd = {0.1, 0.5, 0.2}};
    return render_figure(range_profile_figure(
                             "profile", {.panels = {{"a", "A", {profile}}, {"b", "B", {profile}}},
                                         .class_names = {"iron"},
                                         .first_bin = 6,
                                         .quantity = "magnitude",
                                         .marked_bin = {}}))
        .svg;
}

struct Ids {
    std::vector<std::string> defined, used;
};

Ids ids_of(std::string_view markup) {
    Ids ids;
    walk_markup(
        markup,
        [&](std::string_view tag) {
            if (const auto id = attribute(tag, "id"); !id.empty()) ids.defined.emplace_back(id);
            if (const auto use = attribute(tag, "xlink:href"); use.starts_with('#'))
                ids.used.emplace_back(use.substr(1));
        },
        [](std::string_view) {});
    return ids;
}

}  // namespace

TEST_CASE("several drawings on one page share no id, and references still resolve", "[report]") {
    const std::string svg = profile_svg();
    const Ids ids = ids_of(inline_svg(svg, "f1") + inline_svg(svg, "f2"));
    const std::set<std::string> unique(ids.defined.begin(), ids.defined.end());
    CHECK(ids.defined.size() > 20);
    CHECK(unique.size() == ids.defined.size());
    CHECK(ids.used.size() > 4);
    CHECK(std::all_of(ids.used.begin(), ids.used.end(),
                      [&](const std::string& id) { return unique.contains(id); }));
}

TEST_CASE("ink follows the page and the ground is the page's", "[report]") {
    const std::string svg = inline_svg(profile_svg(), "f1");
    CHECK(svg.find("black") == std::string::npos);
    CHECK(svg.find("rgb(0,0,0)") == std::string::npos);
    CHECK(svg.find("fill=\"#ffffff\"") == std::string::npos);
    CHECK(svg.find("currentColor") != std::string::npos);
    CHECK(svg.find("var(--series-1)") != std::string::npos);
    CHECK(svg.find("var(--rule)") != std::string::npos);
}

TEST_CASE("cells of the heat map and the numbers on them keep their colours", "[report]") {
    ConditionReport report = made_up_study().conditions.front().result;
    const auto svg = render_figure(confusion_figure("c", report, made_up_study().class_names)).svg;
    const std::string inlined = inline_svg(svg, "f1");
    const auto count = [](std::string_view text, std::string_view part) {
        std::size_t n = 0;
        for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
        return n;
    };
    CHECK(count(inlined, "<polygon") >= 25);
    CHECK(count(inlined, "rgb(255,255,255)") == count(svg, "rgb(255,255,255)"));
    CHECK(count(inlined, "rgb(5,5,5)") == count(svg, "rgb(5,5,5)"));
    CHECK(count(inlined, "rgb(5,5,5)") > 0);
}

TEST_CASE("a drawing tells its title and what it shows to those who do not see it", "[report]") {
    const std::string svg = inline_svg(profile_svg(), "f1");
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.find("role=\"img\" aria-labelledby=\"f1-title f1-desc\"") != std::string::npos);
    CHECK(svg.find("<title id=\"f1-title\">Descriptor of every class") != std::string::npos);
    CHECK(svg.find("gnuplot_plot_1") == std::string::npos);
    CHECK(svg.find("Produced by") == std::string::npos);
}
