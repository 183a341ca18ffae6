#include "tools/report/risk_coverage_figure.hpp"

#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/number_text.hpp"

namespace specula {
namespace {

constexpr Canvas risk_canvas{.width_px = 480, .height_px = 412};
constexpr PixelBox risk_area{.left = 56, .top = 52, .right = 464, .bottom = 356};
constexpr double accepted_risk = 0.05;
constexpr std::size_t most_points = 400;

/// Evenly spread places of the curve, its last among them.
std::vector<std::size_t> drawn_points(const RiskCoverage& curve) {
    const std::size_t n = curve.risk.size();
    const std::size_t n_points = std::min(n, most_points);
    std::vector<std::size_t> points;
    for (std::size_t k = 1; k <= n_points; ++k) points.push_back(k * n / n_points - 1);
    return points;
}

std::string script(const std::string& title, const std::string& second_line,
                   const RiskCoverage& curve) {
    std::string block = "$curve << END\n";
    for (const std::size_t k : drawn_points(curve))
        block += format("{} {}\n", 100.0 * curve.coverage(k), 100.0 * curve.risk[k]);
    block += "END\n";
    const double highest = *std::ranges::max_element(curve.risk);
    const double top = 100.0 * std::min(1.0, std::max(1.15 * highest, 2.0 * accepted_risk));
    return axes_style() + format("set xrange [0:100]\nset yrange [0:{}]\nset xtics 20\n", top) +
           risk_canvas.frame(risk_area) + risk_canvas.heading(risk_area, title, second_line) +
           risk_canvas.axis_titles(risk_area, "coverage: frames answered, the surest first (%)",
                                   "risk: wrong among them (%)") +
           block +
           format(
               "set arrow from 0, {0} to 100, {0} nohead back dashtype (4,3) linecolor rgb "
               "'{1}'\nplot $curve using 1:2 with lines linewidth 1.8 linecolor rgb '{2}'\n",
               100.0 * accepted_risk, soft_ink, series_colour(0));
}

}  // namespace

Figure risk_coverage_figure(const std::string& name, const std::string& title,
                            const RiskCoverage& curve) {
    CsvTable table({"coverage_share", "risk_share"});
    for (const std::size_t k : drawn_points(curve))
        table.add({format("{}", curve.coverage(k)), format("{}", curve.risk[k])});
    const std::string second_line =
        format("at 5\u00a0% risk (dashed) {} are answered; area under the curve {}",
               percent_text(coverage_at_risk(curve, accepted_risk)),
               fixed_text(area_under_risk_coverage(curve), 3));
    return {.name = name,
            .title = "Risk over coverage: " + title,
            .description = format("With all frames answered, {} are wrong; {}.",
                                  percent_text(curve.risk.back()), second_line),
            .script = script(title, second_line, curve),
            .csv = table.text(),
            .width_in = risk_canvas.width_in(),
            .height_in = risk_canvas.height_in()};
}

}  // namespace specula
