#include "tools/report/range_profile_figure.hpp"

#include <algorithm>
#include <limits>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/panel_grid.hpp"

namespace specula {
namespace {

PanelGrid grid_of(const ProfilePanels& content) {
    PanelGrid grid{.n_panels = content.panels.size()};
    for (const ProfilePanel& panel : content.panels) {
        const auto lines = wrapped(panel.title, grid.panel_width_px(), true).size();
        grid.title_px = std::max(grid.title_px, PanelGrid::line_px * static_cast<double>(lines));
    }
    return grid;
}

struct Span {
    double low = 0.0;
    double high = std::numeric_limits<double>::lowest();
};

/// Holds every band. Zero belongs to it: magnitudes are compared by their ratio.
Span span_of(const ProfilePanels& content) {
    Span span;
    for (const ProfilePanel& panel : content.panels)
        for (const ClassProfile& profile : panel.classes)
            for (std::size_t i = 0; i < profile.mean.size(); ++i) {
                span.high = std::max(span.high, profile.mean[i] + profile.sd[i]);
                span.low = std::min(span.low, profile.mean[i]);
            }
    span.high = span.high > span.low ? span.low + 1.04 * (span.high - span.low) : span.low + 1.0;
    return span;
}

/// (bin, mean, mean - sd, mean + sd)
std::string profile_block(std::string_view name, const ClassProfile& profile, int first_bin) {
    std::string text = format("${} << END\n", name);
    for (std::size_t i = 0; i < profile.mean.size(); ++i)
        text += format("{} {} {} {}\n", first_bin + static_cast<int>(i), profile.mean[i],
                       profile.mean[i] - profile.sd[i], profile.mean[i] + profile.sd[i]);
    return text + "END\n";
}

std::string panel_title(const Canvas& canvas, const PixelBox& box, const std::string& title) {
    const auto lines = wrapped(title, box.right - box.left, true);
    std::string commands;
    for (std::size_t i = 0; i < lines.size(); ++i)
        commands += canvas.label(
            {.text = lines[i],
             .x_px = box.left,
             .y_px = box.top - PanelGrid::title_gap_px -
                     PanelGrid::line_px * (static_cast<double>(lines.size() - i) - 0.5),
             .bold = true});
    return commands;
}

std::string panel_frame(const PanelGrid& grid, std::size_t index, const std::string& title) {
    const PixelBox box = grid.panel(index);
    const Canvas canvas = grid.canvas();
    std::string commands =
        format("unset label\nset format y '{}'\n", index % grid.n_columns() == 0 ? "%g" : "") +
        canvas.frame(box) + panel_title(canvas, box, title);
    if (grid.is_lowest(index))
        commands += canvas.label({.text = "range bin",
                                  .x_px = 0.5 * (box.left + box.right),
                                  .y_px = box.bottom + 40,
                                  .align = "center",
                                  .colour = soft_ink});
    return commands;
}

/// What stands once on the figure; drawn with the first panel.
std::string legend(const ProfilePanels& content, const PanelGrid& grid) {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < content.class_names.size(); ++i)
        entries.push_back({.label = content.class_names[i],
                           .colour = series_colour(i),
                           .marker = Marker::line_point,
                           .point_type = series_point(i),
                           .point_size = 0.55});
    const Canvas canvas = grid.canvas();
    return legend_row(canvas, PanelGrid::left_px, 14, entries).commands +
           canvas.label(
               {.text = content.quantity,
                .x_px = 10,
                .y_px = 0.5 * (PanelGrid::legend_px + canvas.height_px - PanelGrid::bottom_px),
                .align = "center",
                .colour = soft_ink,
                .upwards = true});
}

std::string panel_plot(const ProfilePanels& content, std::size_t panel) {
    std::string bands, lines;
    for (std::size_t i = 0; i < content.panels[panel].classes.size(); ++i) {
        const std::string block = format("$p{}_{}", panel, i);
        bands += format(
            "{}{} using 1:3:4 with filledcurves fillstyle transparent solid 0.16 "
            "noborder linecolor rgb '{}'",
            i > 0 ? ", " : "plot ", block, series_colour(i));
        lines += format(
            ", {} using 1:2 with linespoints pointtype {} pointsize 0.45 linewidth 1.3 "
            "linecolor rgb '{}'",
            block, series_point(i), series_colour(i));
    }
    return bands + lines + "\n";
}

std::string common_axes(const ProfilePanels& content) {
    const Span span = span_of(content);
    const std::size_t n_bins = content.panels.front().classes.front().mean.size();
    const int last_bin = content.first_bin + static_cast<int>(n_bins) - 1;
    std::string text =
        format("set grid ytics noxtics\nset xrange [{}:{}]\nset yrange [{}:{}]\nset xtics {},1\n",
               content.first_bin - 0.4, last_bin + 0.4, span.low, span.high, content.first_bin);
    if (content.marked_bin)
        text += format(
            "set arrow 1 from {0}, graph 0 to {0}, graph 1 nohead back linewidth 1 "
            "dashtype (5,4) linecolor rgb '{1}'\n",
            *content.marked_bin, soft_ink);
    return text;
}

std::string script(const ProfilePanels& content, const PanelGrid& grid) {
    std::string text = axes_style() + common_axes(content);
    for (std::size_t panel = 0; panel < content.panels.size(); ++panel)
        for (std::size_t i = 0; i < content.panels[panel].classes.size(); ++i)
            text += profile_block(format("p{}_{}", panel, i), content.panels[panel].classes[i],
                                  content.first_bin);
    text += "set multiplot\n";
    for (std::size_t panel = 0; panel < content.panels.size(); ++panel)
        text += panel_frame(grid, panel, content.panels[panel].title) +
                (panel == 0 ? legend(content, grid) : "") + panel_plot(content, panel) +
                (panel == 0 ? "unset for [i=2:99] arrow i\n" : "");
    return text + "unset multiplot\n";
}

std::string csv(const ProfilePanels& content) {
    CsvTable table({"condition", "class", "range_bin", "mean", "sd"});
    for (const ProfilePanel& panel : content.panels)
        for (std::size_t i = 0; i < panel.classes.size(); ++i)
            for (std::size_t bin = 0; bin < panel.classes[i].mean.size(); ++bin)
                table.add({panel.name, content.class_names[i],
                           format("{}", content.first_bin + static_cast<int>(bin)),
                           format("{}", panel.classes[i].mean[bin]),
                           format("{}", panel.classes[i].sd[bin])});
    return table.text();
}

void expect_complete(const ProfilePanels& content) {
    SPECULA_EXPECT(!content.panels.empty() && !content.class_names.empty());
    for (const ProfilePanel& panel : content.panels) {
        SPECULA_EXPECT(panel.classes.size() == content.class_names.size());
        for (const ClassProfile& profile : panel.classes)
            SPECULA_EXPECT(!profile.mean.empty() && profile.mean.size() == profile.sd.size());
    }
}

}  // namespace

Figure range_profile_figure(const std::string& name, const ProfilePanels& content) {
    expect_complete(content);
    const PanelGrid grid = grid_of(content);
    return {.name = name,
            .title = "Descriptor of every class under each condition",
            .description = format(
                "Small multiples, one per condition: mean of the {} range bins of the descriptor "
                "per class, with a band of one standard deviation either side.",
                content.panels.front().classes.front().mean.size()),
            .script = script(content, grid),
            .csv = csv(content),
            .width_in = grid.canvas().width_in(),
            .height_in = grid.canvas().height_in()};
}

}  // namespace specula
