#include "tools/firmware/latency_figure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"

namespace specula {

namespace {

constexpr Canvas canvas{.width_px = 640, .height_px = 400};
constexpr PixelBox area{.left = 62, .top = 62, .right = 620, .bottom = 346};
const std::vector<std::string> arithmetics{"float32", "int16", "int8"};

/// us at the middle, F1, us low and high, F1 low and high
std::string block(const LatencyStudy& study, std::size_t series) {
    std::string text = format("$series_{} << END\n", series);
    for (const LatencyPoint& point : study.points)
        if (point.arithmetic == arithmetics[series])
            text += format("{} {} {} {} {} {}\n", point.cycles.mean() / cycles_per_us,
                           100.0 * point.nominal.mean, point.cycles.low / cycles_per_us,
                           point.cycles.high / cycles_per_us, 100.0 * point.nominal.low,
                           100.0 * point.nominal.high);
    return text + "END\n";
}

/// The axis of macro-F1: data end at 100, above them are two rows of names.
struct ScoreAxis {
    double low = 0.0;
    double percent_per_px = 0.0;

    explicit ScoreAxis(double lowest) : low(std::max(0.0, lowest - 4.0)) {
        percent_per_px = (100.0 - low) / (area.bottom - area.top - names_px);
    }
    double above_px(double px) const { return 100.0 + px * percent_per_px; }
    double step() const {
        const double span = 100.0 - low;
        return span > 40.0 ? 10.0 : span > 16.0 ? 5.0 : span > 8.0 ? 2.0 : 1.0;
    }
    std::string commands() const {
        return format("set yrange [{}:{}]\nset ytics {},{},100\n", low, above_px(names_px),
                      step() * std::ceil(low / step()), step());
    }

    static constexpr double names_px = 44.0;
};

/// us, F1, and where the name of a network stands: in turns in the lower and the upper row, so that
/// neighbours have room, above their float32 point and tied to it by a line.
std::string name_block(const LatencyStudy& study, const ScoreAxis& axis) {
    constexpr double rows_px[] = {14.0, 32.0};
    std::string text = "$names << END\n";
    std::size_t n = 0;
    for (const LatencyPoint& point : study.points) {
        if (point.arithmetic != arithmetics.front()) continue;
        std::string shape;
        for (const int units : point.hidden)
            shape += format("{}{}", shape.empty() ? "" : "-", units);
        text += format("{} {} {} {}\n", point.cycles.mean() / cycles_per_us,
                       100.0 * point.nominal.mean, axis.above_px(rows_px[n++ % 2]), shape);
    }
    return text + "END\n";
}

std::string curves(const ScoreAxis& axis) {
    constexpr double name_half_height_px = 7.0;
    std::string text = format(
        "plot $names using 1:2:(0):($3-$2-{0}) with vectors nohead linewidth 0.6 linecolor rgb "
        "'{1}', $names using 1:3:4 with labels font ',9'",
        axis.percent_per_px * name_half_height_px, soft_ink);
    for (std::size_t i = 0; i < arithmetics.size(); ++i)
        text += format(
            ", $series_{} using 1:2:3:4:5:6 with xyerrorbars pointtype {} pointsize 0.8 linewidth "
            "1.2 linecolor rgb '{}'",
            i, series_point(i), series_colour(i));
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
    const ScoreAxis axis(lowest_f1(study));
    const std::string axes = format(
        "set logscale x 2\nset xrange [4:256]\nset xtics (5,10,20,40,80,160)\nset grid ytics "
        "noxtics\nset arrow from 20, graph 0 to 20, first 100 nohead back dashtype (4,3) linecolor "
        "rgb '{}'\n",
        soft_ink);
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
            .script = axes_style() + axes + axis.commands() + canvas.frame(area) +
                      canvas.heading(area, "Accuracy against time on the chip",
                                     "hidden layers above the float32 points; 20 us dashed") +
                      canvas.axis_titles(area, "network and softmax at 160 MHz, estimated (us)",
                                         "macro-F1, nominal (%)") +
                      legend_row(canvas, area.left + 250, area.bottom - 14, entries).commands +
                      blocks + name_block(study, axis) + curves(axis),
            .csv = latency_csv(study),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace specula
