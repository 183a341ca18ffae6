#include "tools/report/reflection_figure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {
namespace {

constexpr Canvas canvas{.width_px = 912.0, .height_px = 424.0};
constexpr PixelBox left_box{.left = 68.0, .top = 92.0, .right = 458.0, .bottom = 370.0};
constexpr PixelBox right_box{.left = 546.0, .top = 92.0, .right = 900.0, .bottom = 370.0};
constexpr double legend_px = 66.0, lowest_db = -40.0;

using Curves = std::vector<ReflectionCurve>;

/// A round level below all of these curves, but not below `lowest_db`.
double floor_db(const Curves& curves, const Curves& more = {}) {
    double least = 0.0;
    for (const Curves* each : {&curves, &more})
        for (const ReflectionCurve& curve : *each)
            least =
                std::min(least, *std::min_element(curve.level_db.begin(), curve.level_db.end()));
    if (least <= 0.95 * lowest_db) return lowest_db;
    if (least < -2.0) return 5.0 * std::floor(1.02 * least / 5.0);
    double step = 1.0;  // a metal's level is a matter of hundredths
    while (step > -0.5 * least && step > 1e-6) step *= 0.1;
    return step * std::floor(1.05 * least / step);
}

std::string blocks(const std::string& prefix, const Curves& curves) {
    std::string text;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        text += format("${}{} << END\n", prefix, i);
        for (std::size_t k = 0; k < curves[i].x.size(); ++k)
            text += format("{} {}\n", curves[i].x[k], curves[i].level_db[k]);
        text += "END\n";
    }
    return text;
}

std::string legend(const PixelBox& box, const Curves& curves) {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < curves.size(); ++i)
        entries.push_back({.label = curves[i].label,
                           .colour = series_colour(i),
                           .marker = Marker::line_point,
                           .point_type = series_point(i),
                           .point_size = 0.6});
    return legend_row(canvas, box.left, legend_px, entries).commands;
}

/// Points mark the lines at equal distances, those of each curve at others.
std::string firm_lines(const std::string& prefix, const Curves& curves) {
    std::string text;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const std::size_t interval = std::max<std::size_t>(1, curves[i].x.size() / 9);
        const std::size_t first = interval * (2 * i + 1) / (2 * curves.size());
        text += format(
            "{}${}{} using 1:2 with lines linewidth 1.6 linecolor rgb '{}', "
            "'' using 1:2 every {}::{} with points pointtype {} pointsize 0.6 linewidth 1.6 "
            "linecolor rgb '{}'",
            i > 0 ? ", " : "", prefix, i, series_colour(i), interval, first, series_point(i),
            series_colour(i));
    }
    return text;
}

std::string fine_lines(const std::string& prefix, const Curves& curves) {
    std::string text;
    for (std::size_t i = 0; i < curves.size(); ++i)
        text += format(", ${}{} using 1:2 with lines linewidth 1 dashtype (8,5) linecolor rgb '{}'",
                       prefix, i, series_colour(i));
    return text;
}

std::string panel_titles(const PixelBox& box, const std::string& below) {
    return canvas.label({.text = below,
                         .x_px = 0.5 * (box.left + box.right),
                         .y_px = canvas.height_px - 14,
                         .align = "center",
                         .colour = soft_ink}) +
           canvas.label({.text = "reflection over a mirror (dB)",
                         .x_px = box.left - 56,
                         .y_px = 0.5 * (box.top + box.bottom),
                         .align = "center",
                         .colour = soft_ink,
                         .upwards = true});
}

/// Grey where the numbers do not hold, in the panel over frequency.
std::string shade(const ReflectionCurves& content, double from_ghz, double to_ghz) {
    std::string text;
    const double low = std::clamp(content.valid.min_hz * 1e-9, from_ghz, to_ghz);
    const double high = std::clamp(content.valid.max_hz * 1e-9, from_ghz, to_ghz);
    const auto grey = [&](double begin, double end) {
        if (!(begin < end)) return;
        text += format(
            "set object rectangle from {}, graph 0 to {}, graph 1 behind fillstyle solid noborder "
            "fillcolor rgb '{}'\n",
            begin, end, faint(rule_colour, 0.5));
        const double px_per_ghz = (left_box.right - left_box.left) / (to_ghz - from_ghz);
        const Text note{.text = "extrapolated",
                        .x_px = left_box.left + px_per_ghz * (0.5 * (begin + end) - from_ghz),
                        .y_px = left_box.top + 10,
                        .align = "center",
                        .size_px = 11,
                        .colour = soft_ink};
        if (px_per_ghz * (end - begin) > text_width_px(note.text, 11)) text += canvas.label(note);
    };
    if (low == high) {  // the valid band lies wholly to one side
        grey(from_ghz, to_ghz);
    } else {
        grey(from_ghz, low);
        grey(high, to_ghz);
    }
    return text;
}

std::string frequency_panel(const ReflectionCurves& content) {
    const auto& x = content.over_frequency.front().x;
    return format("set xrange [{}:{}]\nset xtics 1\nset yrange [{}:0]\n", x.front(), x.back(),
                  floor_db(content.over_frequency)) +
           canvas.frame(left_box) + canvas.heading(left_box, content.title, content.second_line) +
           legend(left_box, content.over_frequency) + shade(content, x.front(), x.back()) +
           panel_titles(left_box, "frequency (GHz), head-on") + "plot " +
           firm_lines("f", content.over_frequency) + "\n";
}

std::string angle_panel(const ReflectionCurves& content) {
    std::string text =
        format("unset label\nunset object\nset xrange [0:90]\nset xtics 15\nset yrange [{}:0]\n",
               floor_db(content.over_angle, content.beside));
    if (content.brewster_deg)
        text += format(
                    "set arrow from {0}, graph 0 to {0}, graph 1 nohead back linewidth 1 "
                    "dashtype (1,3) linecolor rgb '{1}'\n",
                    *content.brewster_deg, soft_ink) +
                canvas.label({.text = format("Brewster {:.1f}\u00b0", *content.brewster_deg),
                              .x_px = right_box.left + (right_box.right - right_box.left) *
                                                           *content.brewster_deg / 90.0,
                              .y_px = right_box.top - 8,
                              .align = "center",
                              .size_px = 11,
                              .colour = soft_ink});
    return text + canvas.frame(right_box) + legend(right_box, content.over_angle) +
           panel_titles(right_box, content.angle_title) + "plot " +
           firm_lines("a", content.over_angle) + fine_lines("b", content.beside) + "\n";
}

std::string csv(const ReflectionCurves& content) {
    CsvTable table({"panel", "curve", "frequency_ghz_or_incidence_deg", "level_db"});
    const auto add = [&](const char* panel, const Curves& curves) {
        for (const ReflectionCurve& curve : curves)
            for (std::size_t i = 0; i < curve.x.size(); ++i)
                table.add({panel, curve.label, format("{:.6g}", curve.x[i]),
                           format("{:.6g}", curve.level_db[i])});
    };
    add("frequency", content.over_frequency);
    add("angle", content.over_angle);
    add("angle", content.beside);
    return table.text();
}

}  // namespace

Figure reflection_figure(const std::string& name, const ReflectionCurves& content) {
    SPECULA_EXPECT(!content.over_frequency.empty() && !content.over_angle.empty());
    return {.name = name,
            .title = content.title,
            .description = format(
                "Reflected level of {} over that of a mirror, in dB: left against frequency for "
                "{} thicknesses, right against the angle of incidence for both polarisations.",
                content.title, content.over_frequency.size()),
            .script = axes_style() + blocks("f", content.over_frequency) +
                      blocks("a", content.over_angle) + blocks("b", content.beside) +
                      "set multiplot\n" + frequency_panel(content) + angle_panel(content) +
                      "unset multiplot\n",
            .csv = csv(content),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace specula
