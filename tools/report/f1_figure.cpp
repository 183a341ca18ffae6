#include "tools/report/f1_figure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/gnuplot.hpp"
#include "tools/report/number_text.hpp"

namespace specula {
namespace {

constexpr double width_px = 640.0, row_px = 62.0, text_px = 13.0;
constexpr std::size_t all_series = 0, merged_series = 2;
constexpr double mean_size = 0.75, world_size = 0.36;
/// Where things stand in a row, from its middle, in rows. The title has the whole line above the
/// series, so that the axis may use the whole width; a star stands on that line too.
constexpr double title_lane = -0.3, all_lane = 0.02, merged_lane = 0.3;

struct Layout {
    Canvas canvas;
    PixelBox area;

    double x_px(double share) const { return area.left + (area.right - area.left) * share; }
    double y_px(double row) const { return area.top + row_px * (row + 0.5); }
};

Layout layout_of(const F1Rows& content) {
    const double top = 64.0, height = row_px * static_cast<double>(content.rows.size());
    return {.canvas = {.width_px = width_px, .height_px = top + height + 54},
            .area = {.left = 14, .top = top, .right = width_px - 16, .bottom = top + height}};
}

/// (percent, row): worlds spread over their lane by the golden ratio, so that few overlap.
std::string worlds_block(std::string_view block, const F1Rows& content,
                         std::vector<double> F1Row::*worlds, double offset) {
    std::string text = format("${} << END\n", block);
    for (std::size_t row = 0; row < content.rows.size(); ++row) {
        const std::vector<double>& values = content.rows[row].*worlds;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double spread = std::fmod(0.618034 * static_cast<double>(i + 1), 1.0) - 0.5;
            text += format("{} {}\n", 100.0 * values[i],
                           static_cast<double>(row) + offset + 0.2 * spread);
        }
    }
    return text + "NaN NaN\nEND\n";
}

std::string means_block(std::string_view block, const F1Rows& content, Interval F1Row::*series,
                        double offset) {
    std::string text = format("${} << END\n", block);
    for (std::size_t row = 0; row < content.rows.size(); ++row) {
        const Interval& value = content.rows[row].*series;
        text += format("{} {} {} {}\n", 100.0 * value.mean, static_cast<double>(row) + offset,
                       100.0 * value.low, 100.0 * value.high);
    }
    return text + "NaN NaN NaN NaN\nEND\n";
}

std::string stars(const F1Rows& content, const Layout& layout) {
    std::string text;
    for (std::size_t row = 0; row < content.rows.size(); ++row)
        if (const auto& paper = content.rows[row].paper)
            text += layout.canvas.star(layout.x_px(*paper),
                                       layout.y_px(static_cast<double>(row) + title_lane));
    return text;
}

std::string legend(const F1Rows& content, const Layout& layout) {
    const auto series = [](const std::string& label, std::size_t i) {
        return LegendEntry{.label = label,
                           .colour = series_colour(i),
                           .marker = Marker::line_point,
                           .point_type = series_point(i),
                           .point_size = mean_size};
    };
    const double x = layout.area.left, first = 13, second = 35;
    const Legend means = legend_row(
        layout.canvas, x, first,
        {series(content.all_label, all_series), series(content.merged_label, merged_series)});
    const Legend rest = legend_row(layout.canvas, x, second,
                                   {{.label = "single worlds",
                                     .colour = series_colour(6),
                                     .marker = Marker::point,
                                     .point_type = 7,
                                     .point_size = world_size}});
    return means.commands + rest.commands + layout.canvas.star(rest.end_px + 11, second) +
           layout.canvas.label({.text = "the paper", .x_px = rest.end_px + 30, .y_px = second});
}

std::string axes(const F1Rows& content, const Layout& layout) {
    const double last = static_cast<double>(content.rows.size()) - 0.5;
    std::string commands = format(
        "set border 1\nset xrange [0:100]\nset xtics 20\nset yrange [{}:-0.5]\nunset ytics\n"
        "set grid xtics noytics\n",
        last);
    for (std::size_t row = 0; row < content.rows.size(); ++row)
        commands += layout.canvas.label({.text = content.rows[row].title,
                                         .x_px = layout.area.left + 6,
                                         .y_px = layout.y_px(static_cast<double>(row) + title_lane),
                                         .size_px = text_px});
    return commands + layout.canvas.frame(layout.area) +
           layout.canvas.axis_titles(layout.area, "macro-F1 (%)", "");
}

/// Interrupted where the titles stand.
std::string chance_line(const F1Rows& content, const Layout& layout) {
    if (content.n_classes == 0) return {};
    const double chance = 1.0 / static_cast<double>(content.n_classes);
    std::string commands =
        layout.canvas.label({.text = format("chance, {} classes", content.n_classes),
                             .x_px = layout.x_px(chance),
                             .y_px = layout.area.top - 6,
                             .align = "center",
                             .size_px = 11,
                             .colour = soft_ink});
    for (std::size_t row = 0; row < content.rows.size(); ++row)
        commands += format(
            "set arrow from {0}, {1} to {0}, {2} nohead back dashtype (4,3) linecolor "
            "rgb '{3}'\n",
            100.0 * chance, static_cast<double>(row) + title_lane + 0.17,
            static_cast<double>(row) + 0.5, soft_ink);
    return commands;
}

std::string f1_curves() {
    const auto worlds = [](std::string_view block, std::size_t i) {
        return format("${} using 1:2 with points pointtype 7 pointsize {} linecolor rgb '{}'",
                      block, world_size, faint(series_colour(i), 0.62));
    };
    const auto means = [](std::string_view block, std::size_t i) {
        return format(
            "${} using 1:2:3:4 with xerrorbars pointtype {} pointsize {} linewidth 1.7 "
            "linecolor rgb '{}'",
            block, series_point(i), mean_size, series_colour(i));
    };
    return "set errorbars 1.2\nplot " + worlds("all_worlds", all_series) + ", " +
           worlds("merged_worlds", merged_series) + ", " + means("all", all_series) + ", " +
           means("merged", merged_series) + "\n";
}

std::string csv(const F1Rows& content) {
    CsvTable table({"condition", "classes", "what", "world", "macro_f1_share", "low_share", "high_share"});
    const auto add = [&](const F1Row& row, const std::string& classes, const Interval& mean,
                         const std::vector<double>& worlds) {
        table.add({row.name, classes, "mean", "", format("{}", mean.mean), format("{}", mean.low),
                   format("{}", mean.high)});
        for (std::size_t i = 0; i < worlds.size(); ++i)
            table.add(
                {row.name, classes, "world", format("{}", i), format("{}", worlds[i]), "", ""});
    };
    for (const F1Row& row : content.rows) {
        add(row, content.all_label, row.all, row.all_per_world);
        add(row, content.merged_label, row.merged, row.merged_per_world);
        if (row.paper)
            table.add({row.name, content.all_label, "paper", "", format("{}", *row.paper), "", ""});
    }
    return table.text();
}

}  // namespace

Figure f1_figure(const std::string& name, const F1Rows& content) {
    SPECULA_EXPECT(!content.rows.empty());
    const Layout layout = layout_of(content);
    std::string description = "Mean macro-F1 per condition: ";
    for (const F1Row& row : content.rows)
        description += format("{}{} {}", &row == &content.rows.front() ? "" : "; ", row.title,
                              percent_text(row.all.mean));
    return {
        .name = name,
        .title = "Macro-F1 per condition",
        .description = description + ".",
        .script = axes_style() + axes(content, layout) + legend(content, layout) +
                  chance_line(content, layout) + stars(content, layout) +
                  worlds_block("all_worlds", content, &F1Row::all_per_world, all_lane) +
                  worlds_block("merged_worlds", content, &F1Row::merged_per_world, merged_lane) +
                  means_block("all", content, &F1Row::all, all_lane) +
                  means_block("merged", content, &F1Row::merged, merged_lane) + f1_curves(),
        .csv = csv(content),
        .width_in = layout.canvas.width_in(),
        .height_in = layout.canvas.height_in()};
}

}  // namespace specula
