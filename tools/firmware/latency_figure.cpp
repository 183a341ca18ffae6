#include "tools/firmware/latency_figure.hpp"

#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"

namespace specula {

namespace {

constexpr Canvas canvas{.width_px = 640, .height_px = 400};
constexpr PixelBox area{.left = 62, .top = 62, .right = 620, .bottom = 346};
const std::vector<std::string> arithmetics{"float32", "int16", "int8"};

/// us at the middle, F1, us low and high, F1 low and high, network
std::string block(const LatencyStudy& study, std::size_t series) {
    std::string text = format("$series_{} << END\n", series);
    for (const LatencyPoint& point : study.points) {
        if (point.arithmetic != arithmetics[series]) continue;
        std::string shape;
        for (const int units : point.hidden)
            shape += format("{}{}", shape.empty() ? "" : "-", units);
        text += format("{} {} {} {} {} {} {}\n", point.cycles.mean() / cycles_per_us,
                       100.0 * point.nominal.mean, point.cycles.low / cycles_per_us,
                       point.cycles.high / cycles_per_us, 100.0 * point.nominal.low,
                       100.0 * point.nominal.high, shape);
    }
    return text + "END\n";
}

std::string curves() {
    std::string text = "plot ";
    for (std::size_t i = 0; i < arithmetics.size(); ++i)
        text += format(
            "{}$series_{} using 1:2:3:4:5:6 with xyerrorbars pointtype {} pointsize 0.8 linewidth "
            "1.2 linecolor rgb '{}'",
            i == 0 ? "" : ", ", i, series_point(i), series_colour(i));
    text += ", $series_0 using 1:2:7 with labels offset 0,-1.1 font ',9'";
    return text + "\n";
}

double lowest_f1(const LatencyStudy& study) {
    double lowest = 1.0;
    for (const LatencyPoint& point : study.points) lowest = std::min(lowest, point.nominal.low);
    return 100.0 * lowest;
}

}  // namespace

Figure latency_figure(const LatencyStudy& study) {
    std::vector<LegendEntry> entries;
    std::string blocks;
    for (std::size_t i = 0; i < arithmetics.size(); ++i) {
        entries.push_back({.label = arithmetics[i],
                           .colour = series_colour(i),
                           .marker = Marker::line_point,
                           .point_type = series_point(i)});
        blocks += block(study, i);
    }
    const std::string axes = format(
        "set logscale x 2\nset xrange [4:256]\nset xtics (5,10,20,40,80,160)\nset yrange "
        "[{}:100.5]\nset grid ytics noxtics\nset arrow from 20, graph 0 to 20, graph 1 nohead back "
        "dashtype (4,3) linecolor rgb '{}'\n",
        std::max(0.0, lowest_f1(study) - 4.0), soft_ink);
    const std::string description = format(
        "Macro-F1 on held-back nominal frames against the estimated time of network and softmax, "
        "for "
        "{} networks in three arithmetics; bars are the estimate's range and the 95 % interval "
        "over "
        "{} worlds; the dashed line is 20 us.",
        study.points.size() / 3, study.worlds);
    return {.name = "latency",
            .title = "Accuracy against time on the chip",
            .description = description,
            .script = axes_style() + axes + canvas.frame(area) +
                      canvas.heading(area, "Accuracy against time on the chip",
                                     "hidden layers beside the points; 20 us dashed") +
                      canvas.axis_titles(area, "network and softmax at 160 MHz, estimated (us)",
                                         "macro-F1, nominal (%)") +
                      legend_row(canvas, area.left + 10, area.bottom - 14, entries).commands +
                      blocks + curves(),
            .csv = latency_csv(study),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace specula
