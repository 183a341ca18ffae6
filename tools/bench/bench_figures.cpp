#include "tools/bench/bench_figures.hpp"

#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/gnuplot.hpp"

namespace specula {

namespace {

constexpr double row_px = 26.0;

/// Stages from the top in the order in which they run, logarithmic: they lie decades apart.
Figure stages_figure(const BenchReport& report) {
    const auto n = static_cast<double>(report.stages.size());
    const Canvas canvas{.width_px = 640, .height_px = 120 + row_px * n};
    const PixelBox area{.left = 150, .top = 60, .right = 600, .bottom = 60 + row_px * n};
    CsvTable table({"stage", "per", "cpu_us"});
    std::string block = "$stages << END\n", names;
    for (std::size_t i = 0; i < report.stages.size(); ++i) {
        const BenchStage& stage = report.stages[i];
        const double y = n - static_cast<double>(i);
        block += format("{} {} {:.1f}\n", stage.microseconds, y, stage.microseconds);
        names += format("{}{} {}", i > 0 ? ", " : "", gnuplot_quoted(stage.name), y);
        table.add({stage.name, stage.per_frame ? "frame" : "session",
                   format("{:.3f}", stage.microseconds)});
    }
    const std::string axes = format(
        "set logscale x\nset xrange [0.1:*]\nset format x '%g'\nset yrange [0.4:{}]\n"
        "set ytics ({}) scale 0\nset grid xtics noytics\nset style fill solid noborder\n",
        n + 0.6, names);
    const std::string curves = format(
        "plot $stages using 1:2:(0.1):1:($2-0.3):($2+0.3) with boxxyerror fillcolor rgb '{}', "
        "$stages using 1:2:3 with labels left offset 0.6,0 font ',10'\n",
        series_colour(1));
    const std::string title = "CPU time of a session, stage by stage";
    return {.name = "bench_stages",
            .title = title,
            .description = "Microseconds per session, the last bar per frame.",
            .script = axes_style() + block + "END\n" + axes + canvas.frame(area) +
                      canvas.heading(area, title, "the last bar is per frame") +
                      canvas.axis_titles(area, "microseconds", "") + curves,
            .csv = table.text(),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

Figure growth_figure(const BenchReport& report) {
    const Canvas canvas{.width_px = 640, .height_px = 420};
    const PixelBox area{.left = 70, .top = 60, .right = 400, .bottom = 364};
    CsvTable table({"axis", "size", "over_smallest", "cpu_s"});
    std::string blocks, curves, legend;
    for (std::size_t i = 0; i < report.growth.size(); ++i) {
        const BenchGrowth& growth = report.growth[i];
        const BenchGrowth::Point& first = growth.points.front();
        blocks += format("$g{} << END\n", i);
        for (const BenchGrowth::Point& point : growth.points) {
            blocks += format("{} {}\n", point.size / first.size, 1e3 * point.seconds);
            table.add({growth.axis, format("{:g}", point.size),
                       format("{:.6g}", point.size / first.size), format("{:.6g}", point.seconds)});
        }
        blocks += "END\n";
        curves += format(
            "{}$g{} using 1:2 with linespoints pointtype {} linewidth 1.4 linecolor rgb '{}'",
            i == 0 ? "plot " : ", ", i, series_point(i), series_colour(i));
        legend +=
            legend_row(canvas, area.right + 14, area.top + 14 + row_px * static_cast<double>(i),
                       {{.label = format("{}: {:.2f}", growth.axis, growth.exponent()),
                         .colour = series_colour(i),
                         .marker = Marker::line_point,
                         .point_type = series_point(i)}})
                .commands;
    }
    const std::string title = "How the time of a frame, or of a session of frames, grows";
    return {.name = "bench_growth",
            .title = title,
            .description =
                "CPU time against how many times larger than the smallest; the numbers "
                "after the names are exponents of a power law, 1 is linear.",
            .script = axes_style() + blocks +
                      "set logscale xy\nset format x '%g'\nset format y '%g'\nset grid\n" +
                      canvas.frame(area) +
                      canvas.heading(area, title,
                                     "after each name the exponent: 1 is linear, less is better") +
                      canvas.axis_titles(area, "times the smallest size", "CPU time (ms)") +
                      legend + curves + "\n",
            .csv = table.text(),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace

bool draws_figures(const BenchPlan& plan) {
    return plan.parts.empty() || std::ranges::any_of(plan.parts, [](const std::string& part) {
               return part == "stages" || part == "growth";
           });
}

std::vector<Figure> bench_figures(const BenchReport& report) {
    std::vector<Figure> figures;
    if (!report.stages.empty()) figures.push_back(stages_figure(report));
    if (!report.growth.empty()) figures.push_back(growth_figure(report));
    return figures;
}

}  // namespace specula
