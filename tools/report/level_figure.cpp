#include "tools/report/level_figure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {
namespace {

constexpr double figure_px = 912.0, left_px = 68.0, right_px = 16.0, gap_px = 24.0;
constexpr double heading_px = 52.0, legend_row_px = 20.0, title_px = 26.0, below_px = 40.0;
constexpr double deepest_db = 60.0;  ///< below the highest level; what is lower leaves the panel
constexpr double marks_per_curve = 9.0;

struct Span {
    double low, high;
};

/// Where everything stands.
struct Layout {
    std::size_t n_panels, n_columns, n_legend_rows;

    double panel_px() const { return n_panels > n_columns ? 200.0 : 290.0; }
    double row_px() const { return (n_panels > 1 ? title_px : 8.0) + panel_px(); }
    double top_px() const {
        return heading_px + legend_row_px * static_cast<double>(n_legend_rows);
    }
    std::size_t n_rows() const { return (n_panels + n_columns - 1) / n_columns; }
    Canvas canvas() const {
        const auto rows = static_cast<double>(n_rows());
        return {figure_px, top_px() + rows * row_px() + (rows - 1.0) * below_px + 54.0};
    }
    PixelBox box(std::size_t panel) const {
        const auto columns = static_cast<double>(n_columns);
        const double width = (figure_px - left_px - right_px - (columns - 1.0) * gap_px) / columns;
        const double left = left_px + static_cast<double>(panel % n_columns) * (width + gap_px);
        const auto row = static_cast<double>(panel / n_columns);
        const double bottom = top_px() + (row + 1.0) * row_px() + row * below_px;
        return {left, bottom - panel_px(), left + width, bottom};
    }
    bool is_lowest(std::size_t panel) const { return panel + n_columns >= n_panels; }
};

std::vector<std::string> labels_of(const LevelPanels& content) {
    std::vector<std::string> labels;
    for (const LevelPanel& panel : content.panels)
        for (const LevelCurve& curve : panel.curves)
            if (std::find(labels.begin(), labels.end(), curve.label) == labels.end())
                labels.push_back(curve.label);
    return labels;
}

template <typename Member>
Span span_of(const LevelPanels& content, const Member member) {
    Span span{INFINITY, -INFINITY};
    for (const LevelPanel& panel : content.panels)
        for (const auto* curves : {&panel.curves, &panel.beside})
            for (const LevelCurve& curve : *curves)
                for (const double value : curve.*member)
                    span = {std::min(span.low, value), std::max(span.high, value)};
    return span;
}

/// A little more than the levels take up, but not endlessly deep.
Span level_span(const LevelPanels& content) {
    Span span = span_of(content, &LevelCurve::level);
    span.low = std::max(span.low, span.high - deepest_db);
    const double margin = std::max(0.06 * (span.high - span.low), 0.25);
    return {span.low - margin, span.high + margin};
}

/// The legend in as many rows as it needs.
struct Rows {
    std::string commands;
    std::size_t n = 1;
};
Rows legend_rows(const std::vector<std::string>& labels, const Canvas& canvas) {
    Rows rows;
    double x_px = left_px;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const LegendEntry entry{.label = labels[i],
                                .colour = series_colour(i),
                                .marker = Marker::line_point,
                                .point_type = series_point(i),
                                .point_size = 0.6};
        const double y_px = heading_px + legend_row_px * (static_cast<double>(rows.n) - 0.5);
        Legend placed = legend_row(canvas, x_px, y_px, {entry});
        if (placed.end_px > figure_px && x_px > left_px) {
            ++rows.n;
            placed = legend_row(canvas, left_px, y_px + legend_row_px, {entry});
        }
        rows.commands += placed.commands;
        x_px = placed.end_px;
    }
    return rows;
}

Layout layout_of(const LevelPanels& content, const std::vector<std::string>& labels) {
    const std::size_t n = content.panels.size();
    Layout layout{n, std::min<std::size_t>(n == 4 ? 2 : 3, n), 1};  // four stand in a square
    layout.n_legend_rows = legend_rows(labels, layout.canvas()).n;
    return layout;
}

std::string block(const std::string& name, const LevelCurve& curve) {
    std::string text = format("${} << END\n", name);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        text += format("{:.9g} {:.9g}\n", curve.x[i], curve.level[i]);
    return text + "END\n";
}

/// A line, with marks at some of its points, each curve's at others.
std::string line(const std::string& name, const LevelCurve& curve, std::size_t series) {
    const auto n = curve.x.size();
    const auto interval = static_cast<std::size_t>(
        std::max(1.0, std::round(static_cast<double>(n) / marks_per_curve)));
    return format(
        "${0} using 1:2 with lines linewidth 1.6 linecolor rgb '{1}', ${0} using 1:2 every "
        "{2}::{3} "
        "with points pointtype {4} pointsize 0.6 linewidth 1.6 linecolor rgb '{1}'",
        name, series_colour(series), interval, interval * series / most_level_curves,
        series_point(series));
}

std::string panel_plot(const LevelPanels& content, std::size_t index,
                       const std::vector<std::string>& labels) {
    const LevelPanel& panel = content.panels[index];
    std::string blocks, lines;
    const auto separator = [&] { return lines.empty() ? "plot " : ", "; };
    for (std::size_t i = 0; i < panel.beside.size(); ++i) {
        const std::string name = format("b{}_{}", index, i);
        blocks += block(name, panel.beside[i]);
        lines +=
            format("{}${} using 1:2 with lines linewidth 1.2 dashtype (6,4) linecolor rgb '{}'",
                   separator(), name, soft_ink);
    }
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
        const std::string name = format("p{}_{}", index, i);
        const auto series = std::find(labels.begin(), labels.end(), panel.curves[i].label);
        blocks += block(name, panel.curves[i]);
        lines += separator() +
                 line(name, panel.curves[i], static_cast<std::size_t>(series - labels.begin()));
    }
    return blocks + lines + "\n";
}

std::string panel_frame(const LevelPanels& content, std::size_t index, const Layout& layout) {
    const Canvas canvas = layout.canvas();
    const PixelBox box = layout.box(index);
    std::string text = format("set format y '{}'\n", index % layout.n_columns == 0 ? "%g" : "") +
                       canvas.frame(box) +
                       canvas.label({.text = content.panels[index].title,
                                     .x_px = box.left,
                                     .y_px = box.top - 10.0,
                                     .bold = true});
    if (layout.is_lowest(index))
        text += canvas.label({.text = content.x_title,
                              .x_px = 0.5 * (box.left + box.right),
                              .y_px = box.bottom + 40.0,
                              .align = "center",
                              .colour = soft_ink});
    return text;
}

std::string script(const LevelPanels& content, const std::vector<std::string>& labels) {
    const Layout layout = layout_of(content, labels);
    const Canvas canvas = layout.canvas();
    const PixelBox area{left_px, layout.top_px(), figure_px - right_px, canvas.height_px - 54.0};
    const Span x = span_of(content, &LevelCurve::x), level = level_span(content);
    std::string text = axes_style() + format(
                                          "set grid ytics xtics\nset xrange [{:.9g}:{:.9g}]\n"
                                          "set yrange [{:.9g}:{:.9g}]\nset multiplot\n",
                                          x.low, x.high, level.low, level.high);
    const std::string once = canvas.heading(area, content.title, content.second_line) +
                             legend_rows(labels, canvas).commands +
                             canvas.label({.text = content.level_title,
                                           .x_px = 10.0,
                                           .y_px = 0.5 * (area.top + area.bottom),
                                           .align = "center",
                                           .colour = soft_ink,
                                           .upwards = true});
    for (std::size_t i = 0; i < content.panels.size(); ++i)
        text += "unset label\n" + std::string(i == 0 ? once : "unset object\nunset arrow\n") +
                panel_frame(content, i, layout) + panel_plot(content, i, labels);
    return text + "unset multiplot\n";
}

std::string csv(const LevelPanels& content) {
    CsvTable table({"panel", "curve", content.x_title, content.level_title});
    for (const LevelPanel& panel : content.panels)
        for (const auto* curves : {&panel.curves, &panel.beside})
            for (const LevelCurve& curve : *curves)
                for (std::size_t i = 0; i < curve.x.size(); ++i)
                    table.add({panel.title, curve.label, format("{:.9g}", curve.x[i]),
                               format("{:.9g}", curve.level[i])});
    return table.text();
}

}  // namespace

Figure level_figure(const std::string& name, const LevelPanels& content) {
    const std::vector<std::string> labels = labels_of(content);
    SPECULA_EXPECT(!labels.empty() && labels.size() <= most_level_curves);
    SPECULA_EXPECT(content.panels.size() <= most_level_panels);
    for (const LevelPanel& panel : content.panels) SPECULA_EXPECT(!panel.curves.empty());
    const Canvas canvas = layout_of(content, labels).canvas();
    return {.name = name,
            .title = content.title,
            .description =
                format("{} against {}, {} curves in {} panels: {}.", content.level_title,
                       content.x_title, labels.size(), content.panels.size(), content.second_line),
            .script = script(content, labels),
            .csv = csv(content),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace specula
