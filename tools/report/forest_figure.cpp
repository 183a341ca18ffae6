#include "tools/report/forest_figure.hpp"

#include <algorithm>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {
namespace {

constexpr double forest_px = 912.0, label_gap_px = 12.0;
constexpr std::size_t many_rows = 16;
constexpr std::string_view band_colour = "#d9dde3";

/// Many rows stand closer.
double lane_px(const ForestContent& content) {
    return content.rows.size() > many_rows ? 8.0 : 13.0;
}

struct ForestLayout {
    Canvas canvas;
    PixelBox area;
    double pitch_px;
};

ForestLayout forest_layout(const ForestContent& content) {
    double label_px = 0.0;
    for (const ForestRow& row : content.rows)
        label_px = std::max(label_px, text_width_px(row.label, figure_font_px, row.emphasised));
    const double left = std::min(1.03 * label_px + label_gap_px + 22.0, 0.62 * forest_px);
    const bool has_legend = content.series.size() > 1 || !content.band_label.empty();
    const double top = has_legend ? 78.0 : 54.0;
    const double pitch_px = lane_px(content) * (static_cast<double>(content.series.size()) + 1.0);
    const double bottom = top + pitch_px * static_cast<double>(content.rows.size());
    return {.canvas = {.width_px = forest_px, .height_px = bottom + 52.0},
            .area = {.left = left, .top = top, .right = forest_px - 18.0, .bottom = bottom},
            .pitch_px = pitch_px};
}

double lane_offset(std::size_t series, const ForestContent& content, double pitch_px) {
    const auto n = static_cast<double>(content.series.size());
    return (static_cast<double>(series) - 0.5 * (n - 1.0)) * lane_px(content) / pitch_px;
}

std::string forest_labels(const ForestContent& content, const ForestLayout& layout) {
    std::string text;
    for (std::size_t i = 0; i < content.rows.size(); ++i) {
        const ForestRow& row = content.rows[i];
        const double y = layout.area.top + layout.pitch_px * (static_cast<double>(i) + 0.5);
        text += layout.canvas.label({.text = row.label,
                                     .x_px = layout.area.left - label_gap_px,
                                     .y_px = y,
                                     .align = "right",
                                     .bold = row.emphasised});
        if (!row.band) continue;
        text += format(
            "set object rectangle from {}, {} to {}, {} back fillstyle solid 1.0 noborder "
            "fillcolor rgb '{}'\n",
            std::max((*row.band)[0], content.range[0]), static_cast<double>(i) - 0.36,
            std::min((*row.band)[1], content.range[1]), static_cast<double>(i) + 0.36, band_colour);
    }
    return text;
}

std::string forest_legend(const ForestContent& content, const ForestLayout& layout) {
    std::vector<LegendEntry> entries;
    if (content.series.size() > 1) entries = interval_legend(content.series);
    if (!content.band_label.empty())
        entries.push_back(
            {.label = content.band_label, .colour = band_colour, .marker = Marker::patch});
    return legend_row(layout.canvas, 14.0, 58.0, entries).commands;
}

std::string forest_data(const ForestContent& content, double pitch_px) {
    std::string blocks, plots;
    for (std::size_t series = 0; series < content.series.size(); ++series) {
        blocks += format("$s{} << END\n", series);
        for (std::size_t i = 0; i < content.rows.size(); ++i)
            if (const auto& value = content.rows[i].values[series])
                blocks += format("{:.9g} {:.6g} {:.9g} {:.9g}\n", value->mean,
                                 static_cast<double>(i) + lane_offset(series, content, pitch_px),
                                 value->low, value->high);
        blocks += "NaN NaN NaN NaN\nEND\n";
        plots += format(
            "{}$s{} using 1:2:3:4 with xerrorbars pointtype {} pointsize 0.7 linewidth 1.6 "
            "linecolor rgb '{}'",
            series == 0 ? "plot " : ", ", series, series_point(2 * series),
            series_colour(2 * series));
    }
    return blocks + plots + "\n";
}

std::string forest_script(const ForestContent& content) {
    const ForestLayout layout = forest_layout(content);
    std::string text =
        axes_style() + format(
                           "set border 1\nunset ytics\nset grid xtics noytics\n"
                           "set errorbars 0.7\nset xrange [{}:{}]\nset yrange [{}:-0.5]\n",
                           content.range[0], content.range[1],
                           static_cast<double>(content.rows.size()) - 0.5);
    if (content.reference)
        text += format(
            "set arrow from {0}, graph 0 to {0}, graph 1 nohead back linewidth 1 dashtype (4,3) "
            "linecolor rgb '{1}'\n",
            *content.reference, soft_ink);
    const PixelBox heading{.left = 14.0, .top = 0.0, .right = 0.0, .bottom = 0.0};
    return text + layout.canvas.frame(layout.area) +
           layout.canvas.heading(heading, content.title, content.second_line) +
           layout.canvas.axis_titles(layout.area, content.axis_title, "") +
           forest_labels(content, layout) + forest_legend(content, layout) +
           forest_data(content, layout.pitch_px);
}

std::string forest_csv(const ForestContent& content) {
    const std::string& unit = content.csv_unit;
    CsvTable table({"row", "series", "mean_" + unit, "low_" + unit, "high_" + unit,
                    "band_low_" + unit, "band_high_" + unit});
    const auto number = [&](double value) { return format("{:.6g}", content.csv_scale * value); };
    for (const ForestRow& row : content.rows)
        for (std::size_t i = 0; i < content.series.size(); ++i) {
            const auto& value = row.values[i];
            if (!value) continue;
            table.add({row.label, content.series[i], number(value->mean), number(value->low),
                       number(value->high), row.band ? number((*row.band)[0]) : "",
                       row.band ? number((*row.band)[1]) : ""});
        }
    return table.text();
}

}  // namespace

Figure forest_figure(const std::string& name, const ForestContent& content) {
    SPECULA_EXPECT(!content.rows.empty() && !content.series.empty());
    for (const ForestRow& row : content.rows)
        SPECULA_EXPECT(row.values.size() == content.series.size());
    std::string description = content.title + ", " + content.axis_title + ": ";
    for (const ForestRow& row : content.rows)
        if (row.values.front())
            description += format("{}{} {:.1f}", &row == &content.rows.front() ? "" : "; ",
                                  row.label, row.values.front()->mean);
    const Canvas drawing = forest_layout(content).canvas;
    return {.name = name,
            .title = content.title,
            .description = description + ".",
            .script = forest_script(content),
            .csv = forest_csv(content),
            .width_in = drawing.width_in(),
            .height_in = drawing.height_in()};
}

}  // namespace specula
