#include "tools/report/curve_figure.hpp"

#include <algorithm>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {
namespace {

constexpr double curves_px = 912.0, one_panel_px = 560.0, curve_left_px = 64.0, curve_gap_px = 34.0,
                 curve_panel_px = 280.0, legend_line_px = 22.0;

struct CurveLayout {
    Canvas canvas;
    double top;
    std::size_t n_panels;

    PixelBox box(std::size_t panel) const {
        const auto n = static_cast<double>(n_panels);
        const double width =
            (canvas.width_px - curve_left_px - 14.0 - (n - 1.0) * curve_gap_px) / n;
        const double left = curve_left_px + static_cast<double>(panel) * (width + curve_gap_px);
        return {left, top, left + width, top + curve_panel_px};
    }
};

std::vector<LegendEntry> curve_entries(const CurveContent& content) {
    std::vector<LegendEntry> entries;
    for (const CurvePanel& panel : content.panels)
        for (const Curve& curve : panel.curves) {
            const bool known = std::ranges::any_of(
                entries, [&](const LegendEntry& entry) { return entry.label == curve.label; });
            if (known || curve.label.empty()) continue;
            entries.push_back({.label = curve.label,
                               .colour = series_colour(curve.colour),
                               .marker = curve.points_only ? Marker::point : Marker::line_point,
                               .point_type = series_point(curve.colour),
                               .point_size = 0.6});
        }
    return entries;
}

/// The legend in as many lines as its width asks for.
struct LegendLines {
    std::string commands;
    std::size_t n = 1;
};

LegendLines curve_legend(const Canvas& drawing, const std::vector<LegendEntry>& entries) {
    LegendLines lines;
    double x_px = 14.0;
    for (const LegendEntry& entry : entries) {
        const auto y = [&] { return 58.0 + legend_line_px * static_cast<double>(lines.n - 1); };
        Legend placed = legend_row(drawing, x_px, y(), {entry});
        if (placed.end_px > drawing.width_px && x_px > 14.0) {
            ++lines.n;
            placed = legend_row(drawing, 14.0, y(), {entry});
        }
        lines.commands += placed.commands;
        x_px = placed.end_px;
    }
    return lines;
}

CurveLayout curve_layout(const CurveContent& content) {
    const double width = content.panels.size() == 1 ? one_panel_px : curves_px;
    const Canvas wide{.width_px = width, .height_px = 400.0};
    const double top =
        50.0 + legend_line_px * static_cast<double>(curve_legend(wide, curve_entries(content)).n) +
        10.0;
    return {.canvas = {.width_px = width, .height_px = top + curve_panel_px + 56.0},
            .top = top,
            .n_panels = content.panels.size()};
}

std::string curve_blocks(const CurvePanel& panel, std::size_t index) {
    std::string text;
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
        const Curve& curve = panel.curves[i];
        text += format("$c{}_{} << END\n", index, i);
        for (std::size_t k = 0; k < curve.x.size(); ++k)
            text += format("{:.9g} {:.9g} {:.9g} {:.9g}\n", curve.x[k], curve.y[k],
                           curve.low.empty() ? curve.y[k] : curve.low[k],
                           curve.high.empty() ? curve.y[k] : curve.high[k]);
        text += "NaN NaN NaN NaN\nEND\n";
    }
    return text;
}

std::string curve_plots(const CurvePanel& panel, std::size_t index) {
    std::string text = "plot NaN notitle";
    for (std::size_t i = 0; i < panel.curves.size(); ++i)
        if (!panel.curves[i].low.empty())
            text += format(
                ", $c{}_{} using 1:3:4 with filledcurves fillstyle transparent solid 0.18 noborder "
                "linecolor rgb '{}'",
                index, i, series_colour(panel.curves[i].colour));
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
        const Curve& curve = panel.curves[i];
        const bool marked = curve.points_only || curve.x.size() <= 25;
        text += format(
            ", $c{}_{} using 1:2 with {} linewidth 1.6 pointtype {} pointsize 0.6 linecolor rgb "
            "'{}'",
            index, i,
            curve.points_only ? "points"
            : marked          ? "linespoints"
                              : "lines",
            series_point(curve.colour), series_colour(curve.colour));
    }
    return text + "\n";
}

std::string curve_panel(const CurveContent& content, const CurveLayout& layout, std::size_t index) {
    const CurvePanel& panel = content.panels[index];
    const PixelBox box = layout.box(index);
    const auto& x = panel.x_range;
    const auto& y = content.y_range;
    std::string text =
        format("set xrange [{}:{}]\nset format y '{}'\n", x[0], x[1], index == 0 ? "%g" : "") +
        layout.canvas.frame(box) +
        layout.canvas.label({.text = panel.x_title,
                             .x_px = 0.5 * (box.left + box.right),
                             .y_px = box.bottom + 40.0,
                             .align = "center",
                             .colour = soft_ink});
    if (panel.diagonal)
        text += format(
            "set arrow from {0}, {0} to {1}, {1} nohead back dashtype (4,3) linecolor rgb '{2}'\n",
            std::max(x[0], y[0]), std::min(x[1], y[1]), soft_ink);
    if (panel.star) {
        const double across = ((*panel.star)[0] - x[0]) / (x[1] - x[0]);
        const double up = ((*panel.star)[1] - y[0]) / (y[1] - y[0]);
        text += layout.canvas.star(box.left + across * (box.right - box.left),
                                   box.bottom - up * (box.bottom - box.top));
    }
    return text + curve_blocks(panel, index) + curve_plots(panel, index);
}

std::string curve_script(const CurveContent& content) {
    const CurveLayout layout = curve_layout(content);
    const PixelBox heading{.left = 14.0, .top = 0.0, .right = 0.0, .bottom = 0.0};
    std::string text = axes_style() +
                       format("set grid ytics xtics\nset yrange [{}:{}]\nset multiplot\n",
                              content.y_range[0], content.y_range[1]) +
                       layout.canvas.heading(heading, content.title, content.second_line) +
                       curve_legend(layout.canvas, curve_entries(content)).commands +
                       layout.canvas.label({.text = content.y_title,
                                            .x_px = 12.0,
                                            .y_px = layout.top + 0.5 * curve_panel_px,
                                            .align = "center",
                                            .colour = soft_ink,
                                            .upwards = true});
    for (std::size_t i = 0; i < content.panels.size(); ++i)
        text += (i == 0 ? "" : "unset label\nunset arrow\nunset object\n") +
                curve_panel(content, layout, i);
    return text + "unset multiplot\n";
}

std::string curve_csv(const CurveContent& content) {
    CsvTable table({"x_axis", "curve", "x", "y_share", "low_share", "high_share"});
    const auto share = [](double percent) { return format("{:.6g}", 0.01 * percent); };
    for (const CurvePanel& panel : content.panels)
        for (const Curve& curve : panel.curves)
            for (std::size_t k = 0; k < curve.x.size(); ++k)
                table.add({panel.x_title, curve.label, format("{:.6g}", curve.x[k]),
                           share(curve.y[k]), curve.low.empty() ? "" : share(curve.low[k]),
                           curve.high.empty() ? "" : share(curve.high[k])});
    return table.text();
}

}  // namespace

Figure curve_figure(const std::string& name, const CurveContent& content) {
    SPECULA_EXPECT(!content.panels.empty() && content.panels.size() <= 3);
    const Canvas drawing = curve_layout(content).canvas;
    std::string labels;
    for (const LegendEntry& entry : curve_entries(content))
        labels += (labels.empty() ? "" : ", ") + entry.label;
    return {.name = name,
            .title = content.title,
            .description = format("{} against {}: {}.", content.y_title,
                                  content.panels.front().x_title, labels),
            .script = curve_script(content),
            .csv = curve_csv(content),
            .width_in = drawing.width_in(),
            .height_in = drawing.height_in()};
}

}  // namespace specula
