#include "tools/report/reflection_figure.hpp"

#include "materials/library.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/project_library.hpp"
#include "tools/report/reflection_curves.hpp"
#include "tools/report/render_figure.hpp"

using namespace specula;

namespace {

ReflectionCurves curves_of(const std::string& name) {
    return reflection_curves(*library().find(name));
}

/// Where a curve is lowest.
double lowest_x(const ReflectionCurve& curve) {
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (curve.level_db[i] < curve.level_db[lowest]) lowest = i;
    return curve.x[lowest];
}

}  // namespace

TEST_CASE("the TM curve is lowest at the Brewster angle that is marked", "[report]") {
    for (const std::string name : {"plexiglass", "water", "alumina"}) {
        const ReflectionCurves curves = curves_of(name);
        REQUIRE(curves.brewster_deg);
        CHECK(lowest_x(curves.over_angle[1]) ==
              Approx(*curves.brewster_deg).margin(0.25));  // the step of the curve
    }
}

TEST_CASE("a lossless half-wave sheet has its null in the figure", "[report]") {
    // 3 mm of 2.6: half a wave in it at 61.97 GHz for the second order; losses hardly move it.
    const ReflectionCurves curves = curves_of("plexiglass");
    REQUIRE(curves.over_frequency[1].label == "3 mm");
    CHECK(lowest_x(curves.over_frequency[1]) == Approx(61.98).margin(0.1));
}

TEST_CASE("a metal is drawn as one face, without a Brewster angle", "[report]") {
    const ReflectionCurves curves = curves_of("iron");
    CHECK(curves.over_frequency.size() == 1);
    CHECK_FALSE(curves.brewster_deg);
    CHECK(contains(curves.second_line, "skin depth"));
}

TEST_CASE("a grain is drawn along and across", "[report]") {
    const ReflectionCurves curves = curves_of("pine");
    CHECK(curves.over_frequency[0].label == "half-space, along");
    CHECK(curves.over_frequency[0].level_db[0] > curves.over_frequency[1].level_db[0] + 1.0);
}

TEST_CASE("frequencies outside the band are shaded and called so", "[report]") {
    CHECK(
        contains(render_figure(reflection_figure("x", curves_of("marble"))).svg, ">extrapolated<"));
    CHECK_FALSE(
        contains(render_figure(reflection_figure("x", curves_of("concrete"))).svg, "extrapolated"));
}

TEST_CASE("the figure shows its title, its curves and the Brewster angle", "[report]") {
    const Figure figure = reflection_figure("reflection_plexiglass", curves_of("plexiglass"));
    const std::string svg = render_figure(figure).svg;
    for (const std::string_view text : {">Plexiglass (PMMA), cast sheet<", ">half-space<",
                                        ">10 mm<", ">TM, half-space<", "Brewster 58.2"})
        CHECK(contains(svg, text));
    CHECK(contains(figure.csv, "frequency,half-space,57,-12.59"));
    CHECK(contains(figure.csv, "angle,\"TE, 5 mm\",0,"));
}

TEST_CASE("every material of the library can be drawn", "[report]") {
    for (const std::string& name : library().names()) {
        const Figure figure = reflection_figure("x", curves_of(name));
        INFO(name);
        CHECK_FALSE(contains(figure.script, "nan"));
        CHECK_FALSE(contains(figure.script, "inf "));
    }
    CHECK_FALSE(render_figure(reflection_figure("x", curves_of("air"))).svg.empty());
}
