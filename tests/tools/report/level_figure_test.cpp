#include "tools/report/level_figure.hpp"

#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tools/report/render_figure.hpp"

namespace specula {
namespace {

LevelPanels panels_of(std::size_t n_panels, std::size_t n_curves) {
    LevelPanels content{"A title", "a second line", "tilt (degrees)", "level (dB)", {}};
    for (std::size_t i = 0; i < n_panels; ++i) {
        LevelPanel panel{"panel " + std::to_string(i), {}, {}};
        for (std::size_t k = 0; k < n_curves; ++k)
            panel.curves.push_back({"curve " + std::to_string(k),
                                    {0.0, 1.0, 2.0},
                                    {-1.0 * static_cast<double>(k), -2.0, -3.0}});
        content.panels.push_back(std::move(panel));
    }
    return content;
}

TEST_CASE("a level figure names its panels, curves and axes, and holds its numbers", "[report]") {
    const Figure figure = level_figure("x", panels_of(2, 3));
    const std::string svg = render_figure(figure).svg;
    for (const std::string text : {">A title<", ">a second line<", ">panel 0<", ">panel 1<",
                                   ">curve 2<", ">tilt (degrees)<", ">level (dB)<"})
        CHECK(contains(svg, text));
    CHECK(contains(figure.csv, "panel,curve,tilt (degrees),level (dB)\n"));
    CHECK(contains(figure.csv, "panel 1,curve 2,0,-2\n"));
}

TEST_CASE("curves of one label stand once in the legend, however many panels", "[report]") {
    const std::string script = level_figure("x", panels_of(4, 2)).script;
    const std::string label = "set label 'curve 1'";
    REQUIRE(contains(script, label));
    CHECK(script.find(label) == script.rfind(label));
}

TEST_CASE("the legend takes another row when labels are long, and the figure grows", "[report]") {
    LevelPanels content = panels_of(1, 7);
    const double usual_in = level_figure("x", content).height_in;
    for (LevelCurve& curve : content.panels[0].curves) curve.label += std::string(40, '-');
    CHECK(level_figure("x", content).height_in > usual_in);
}

TEST_CASE("nothing far below the highest level stretches the axis", "[report]") {
    LevelPanels content = panels_of(1, 1);
    content.panels[0].curves[0].level = {0.0, -10.0, -300.0};
    CHECK(contains(level_figure("x", content).script, "set yrange [-63.6:3.6]"));
}

}  // namespace
}  // namespace specula
