#include "tools/report/gain_figure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {
namespace {

constexpr double gain_px = 912.0, gain_row_px = 19.0, gain_lane_px = 6.5, gain_gap_px = 12.0;
constexpr double gain_top_px = 104.0, gain_label_px = 10.5, gain_tick_px = 9.5;

struct GainLayout {
    Canvas canvas;
    double left, panel_px, bottom;

    PixelBox box(std::size_t panel) const {
        const double x = left + static_cast<double>(panel) * (panel_px + gain_gap_px);
        return {x, gain_top_px, x + panel_px, bottom};
    }
};

GainLayout gain_layout(const GainContent& content) {
    double label_px = 0.0;
    for (const GainRow& row : content.rows)
        label_px = std::max(label_px, text_width_px(row.label, gain_label_px, row.emphasised));
    const double left = std::min(1.03 * label_px + 26.0, 0.5 * gain_px);
    const auto n = static_cast<double>(content.panels.size());
    const double bottom = gain_top_px + gain_row_px * static_cast<double>(content.rows.size());
    return {.canvas = {.width_px = gain_px, .height_px = bottom + 52.0},
            .left = left,
            .panel_px = (gain_px - left - 14.0 - (n - 1.0) * gain_gap_px) / n,
            .bottom = bottom};
}

/// Whole tens of points around all intervals of a panel, and zero.
struct GainSpan {
    double low = 0.0, high = 0.0;
    /// Two or three ticks: more do not fit side by side.
    double step() const {
        const double width = high - low;
        return width > 100.0 ? 50.0 : width > 50.0 ? 40.0 : width > 20.0 ? 20.0 : 10.0;
    }
};

GainSpan gain_span(const GainContent& content, std::size_t panel) {
    GainSpan span;
    for (const GainRow& row : content.rows)
        for (const Interval& value : row.values[panel]) {
            span.low = std::min(span.low, 10.0 * std::floor(10.0 * value.low));
            span.high = std::max(span.high, 10.0 * std::ceil(10.0 * value.high));
        }
    if (span.high - span.low < 10.0) span.high = span.low + 10.0;
    return span;
}

std::string gain_block(const GainContent& content, std::size_t panel, std::size_t series) {
    std::string text = format("$g{}_{} << END\n", panel, series);
    const auto n = static_cast<double>(content.series.size());
    const double offset =
        (static_cast<double>(series) - 0.5 * (n - 1.0)) * gain_lane_px / gain_row_px;
    for (std::size_t i = 0; i < content.rows.size(); ++i) {
        const Interval& value = content.rows[i].values[panel][series];
        text += format("{:.6g} {:.6g} {:.6g} {:.6g}\n", 100.0 * value.mean,
                       static_cast<double>(i) + offset, 100.0 * value.low, 100.0 * value.high);
    }
    return text + "END\n";
}

std::string gain_panel(const GainContent& content, const GainLayout& layout, std::size_t panel) {
    const PixelBox box = layout.box(panel);
    const GainSpan span = gain_span(content, panel);
    std::string text = layout.canvas.frame(box) +
                       format("set xrange [{}:{}]\nset xtics {} {}\n", span.low, span.high,
                              span.step(), font_clause(gain_tick_px));
    const auto title = wrapped(content.panels[panel], layout.panel_px, true);
    for (std::size_t line = 0; line < title.size(); ++line)
        text += layout.canvas.label(
            {.text = title[line],
             .x_px = 0.5 * (box.left + box.right),
             .y_px = box.top - 12.0 - 14.0 * static_cast<double>(title.size() - 1 - line),
             .align = "center",
             .size_px = gain_label_px,
             .bold = true});
    text += format(
        "set arrow from 0, graph 0 to 0, graph 1 nohead back linewidth 1 linecolor rgb '{}'\n",
        soft_ink);
    std::string plots;
    for (std::size_t series = 0; series < content.series.size(); ++series) {
        text += gain_block(content, panel, series);
        plots += format(
            "{}$g{}_{} using 1:2:3:4 with xerrorbars pointtype {} pointsize 0.4 linewidth 1.2 "
            "linecolor rgb '{}'",
            series == 0 ? "plot " : ", ", panel, series, series_point(2 * series),
            series_colour(2 * series));
    }
    return text + plots + "\nunset label\nunset arrow\nunset object\n";
}

std::string gain_script(const GainContent& content) {
    const GainLayout layout = gain_layout(content);
    const PixelBox heading{.left = 14.0, .top = 0.0, .right = 0.0, .bottom = 0.0};
    const std::vector<LegendEntry> entries = interval_legend(content.series);
    std::string text =
        axes_style() +
        format("set border 1\nunset ytics\nset grid xtics noytics\nset errorbars 0.4\n"
               "set yrange [{}:-0.5]\nset multiplot\n",
               static_cast<double>(content.rows.size()) - 0.5) +
        layout.canvas.heading(heading, content.title, content.second_line) +
        legend_row(layout.canvas, 14.0, 58.0, entries).commands +
        layout.canvas.label({.text = "change of macro-F1 (points)",
                             .x_px = 0.5 * (layout.left + gain_px),
                             .y_px = layout.canvas.height_px - 12.0,
                             .align = "center",
                             .colour = soft_ink});
    for (std::size_t i = 0; i < content.rows.size(); ++i)
        text += layout.canvas.label(
            {.text = content.rows[i].label,
             .x_px = layout.left - 10.0,
             .y_px = gain_top_px + gain_row_px * (static_cast<double>(i) + 0.5),
             .align = "right",
             .size_px = gain_label_px,
             .bold = content.rows[i].emphasised});
    for (std::size_t panel = 0; panel < content.panels.size(); ++panel)
        text += gain_panel(content, layout, panel);
    return text + "unset multiplot\n";
}

std::string gain_csv(const GainContent& content) {
    CsvTable table({"remedy", "condition", "classes", "gain_share", "low_share", "high_share"});
    for (const GainRow& row : content.rows)
        for (std::size_t panel = 0; panel < content.panels.size(); ++panel)
            for (std::size_t series = 0; series < content.series.size(); ++series) {
                const Interval& value = row.values[panel][series];
                table.add({row.label, content.panels[panel], content.series[series],
                           format("{:.6g}", value.mean), format("{:.6g}", value.low),
                           format("{:.6g}", value.high)});
            }
    return table.text();
}

}  // namespace

Figure gain_figure(const std::string& name, const GainContent& content) {
    SPECULA_EXPECT(!content.rows.empty() && !content.panels.empty() && !content.series.empty());
    for (const GainRow& row : content.rows) {
        SPECULA_EXPECT(row.values.size() == content.panels.size());
        for (const auto& values : row.values) SPECULA_EXPECT(values.size() == content.series.size());
    }
    const Canvas drawing = gain_layout(content).canvas;
    return {.name = name,
            .title = content.title,
            .description = format("{}: {} remedies in {} conditions, {}.", content.title,
                                  content.rows.size(), content.panels.size(), content.second_line),
            .script = gain_script(content),
            .csv = gain_csv(content),
            .width_in = drawing.width_in(),
            .height_in = drawing.height_in()};
}

}  // namespace specula
