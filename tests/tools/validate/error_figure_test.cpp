#include "tools/validate/error_figure.hpp"

#include "tests/check.hpp"
#include "tools/report/render_figure.hpp"

namespace specula {
namespace {

CaseVerdict made_up_verdict() {
    const auto point = [](double error) {
        return PointVerdict{.quantities = {{"x", error, 0.0, error, 0.1, "dB"}}, .problem = {}};
    };
    return {
        .id = "M01_x",
        .title = "made up",
        .level = {},
        .kind = "M01",
        .path = {},
        .points = {point(0.0), point(0.05), point(1e9), {.quantities = {}, .problem = "no way"}}};
}

TEST_CASE("the error figure has a row for every point, drawn or not", "[validate][report]") {
    const CaseVerdict verdict = made_up_verdict();
    const Figure figure = error_figure("errors_m", "Materials", {&verdict});
    CHECK(figure.csv ==
          "case,point,verdict,quantity,error,tolerance,unit,error_over_tolerance\n"
          "M01_x,0,pass,x,0,0.1,dB,0\n"
          "M01_x,1,pass,x,0.05,0.1,dB,0.5\n"
          "M01_x,2,FAIL,x,1e+09,0.1,dB,1e+10\n"
          "M01_x,3,cannot compute,,,,,\n");
    CHECK(figure.description.find("M01_x: FAIL") != std::string::npos);
    CHECK(render_figure(figure).svg.find("<svg") != std::string::npos);
}

}  // namespace
}  // namespace specula
