#include "tools/dataset/dataset_figure.hpp"

#include <algorithm>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/dataset/text_histogram.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {

namespace {

constexpr std::size_t most_classes = 9, histogram_intervals = 24;

/// What is drawn, in the order of the panels.
struct Panels {
    std::vector<const ClassSummary*> classes;
    std::vector<const FrameQuantity*> quantities;

    std::size_t size() const { return classes.size() + quantities.size(); }
};

Panels panels_of(const DatasetSummary& summary) {
    Panels panels;
    for (const ClassSummary& each : summary.classes)
        if (!each.profile_mean.empty()) panels.classes.push_back(&each);
    std::stable_sort(panels.classes.begin(), panels.classes.end(),
                     [](const auto* a, const auto* b) { return a->n_frames > b->n_frames; });
    panels.classes.resize(std::min(panels.classes.size(), most_classes));
    for (const FrameQuantity& each : summary.quantities)
        if (!each.values.empty() && histogram_of(each.values, histogram_intervals).width > 0.0)
            panels.quantities.push_back(&each);
    return panels;
}

/// The first bins that hold what can be seen of any class: a spectrum's far half is noise.
std::size_t shown_values(const Panels& panels, bool is_spectrum) {
    constexpr double least_share = 0.02;
    constexpr std::size_t leaking = 4, fewest = 16, margin = 4;
    const std::size_t n = panels.classes.front()->profile_mean.size();
    if (!is_spectrum) return n;
    double peak = 0.0;
    for (const ClassSummary* each : panels.classes)
        for (std::size_t k = leaking; k < n; ++k) peak = std::max(peak, each->profile_mean[k]);
    std::size_t shown = std::min(n, fewest);
    for (const ClassSummary* each : panels.classes)
        for (std::size_t k = shown; k < n; ++k)
            if (each->profile_mean[k] > least_share * peak) shown = k + 1;
    return std::min(n, shown + margin);
}

std::string profile_data(const ClassSummary& each, std::size_t index, std::size_t shown,
                         bool is_amplitude) {
    std::string text = format("$c{} << END\n", index);
    for (std::size_t k = 0; k < shown; ++k) {
        const double mean = each.profile_mean[k], sd = each.profile_sd[k];
        text += format("{} {} {} {}", k, mean, is_amplitude ? std::max(0.0, mean - sd) : mean - sd,
                       mean + sd);
        for (const auto& example : each.examples) text += format(" {}", example[k]);
        text += "\n";
    }
    return text + "END\n";
}

std::string profile_plot(const ClassSummary& each, std::size_t index) {
    const std::string_view colour = series_colour(index);
    std::string text = format(
        "plot $c{0} using 1:3:4 with filledcurves fillstyle solid noborder linecolor rgb '{1}'",
        index, faint(colour, 0.82));
    for (std::size_t i = 0; i < each.examples.size(); ++i)
        text += format(", $c{} using 1:{} with lines linewidth 0.8 linecolor rgb '{}'", index,
                       5 + i, faint(colour, 0.45));
    return text +
           format(", $c{} using 1:2 with lines linewidth 1.8 linecolor rgb '{}'\n", index, colour);
}

/// Where the panels stand: three to a row, each with its own axes.
struct Grid {
    static constexpr double width_px = 912.0, panel_px = 160.0, heading_px = 34.0;
    static constexpr double left_px = 52.0, right_px = 16.0, gap_x_px = 56.0, title_px = 26.0;
    static constexpr double caption_px = 58.0;  ///< below a panel, with the numbers of its axis

    std::size_t n_panels;

    std::size_t n_columns() const { return std::min<std::size_t>(3, n_panels); }
    Canvas canvas() const {
        const auto rows = static_cast<double>((n_panels + n_columns() - 1) / n_columns());
        return {.width_px = width_px,
                .height_px = heading_px + rows * (title_px + panel_px + caption_px)};
    }
    PixelBox panel(std::size_t index) const {
        constexpr double panel_width_px = (width_px - left_px - right_px - 2.0 * gap_x_px) / 3.0;
        const auto column = static_cast<double>(index % 3), row = static_cast<double>(index / 3);
        const double left = left_px + column * (panel_width_px + gap_x_px);
        const double top = heading_px + title_px + row * (title_px + panel_px + caption_px);
        return {.left = left, .top = top, .right = left + panel_width_px, .bottom = top + panel_px};
    }
};

std::string panel_frame(const Grid& grid, std::size_t index, const std::string& title,
                        const std::string& below) {
    const Canvas canvas = grid.canvas();
    const PixelBox box = grid.panel(index);
    return "unset label\n" + canvas.frame(box) +
           canvas.label({.text = title, .x_px = box.left, .y_px = box.top - 12, .bold = true}) +
           canvas.label({.text = below,
                         .x_px = 0.5 * (box.left + box.right),
                         .y_px = box.bottom + 38,
                         .align = "center",
                         .size_px = 11,
                         .colour = soft_ink});
}

std::string histogram_panel(const FrameQuantity& quantity, std::size_t index) {
    const Histogram histogram = histogram_of(quantity.values, histogram_intervals);
    const double n = static_cast<double>(histogram.counts.size());
    std::string text = format("$h{} << END\n", index);
    for (std::size_t i = 0; i < histogram.counts.size(); ++i)
        text +=
            format("{} {}\n", histogram.first + (static_cast<double>(i) + 0.5) * histogram.width,
                   histogram.counts[i]);
    return text + format(
                      "END\nset xrange [{}:{}]\nset yrange [0:*]\nset boxwidth {}\nplot $h{} using "
                      "1:2 with "
                      "boxes fillstyle solid noborder linecolor rgb '{}'\n",
                      histogram.first, histogram.first + n * histogram.width,
                      0.92 * histogram.width, index, faint(series_colour(0), 0.35));
}

/// Highest value drawn of any class, so that their panels share an axis.
double highest(const Panels& panels, std::size_t shown) {
    double most = 0.0;
    for (const ClassSummary* each : panels.classes)
        for (std::size_t k = 0; k < shown; ++k)
            most = std::max(most, each->profile_mean[k] + each->profile_sd[k]);
    return most > 0.0 ? 1.05 * most : 1.0;
}

std::string script_of(const std::string& title, const DatasetSummary& summary,
                      const Panels& panels) {
    const Grid grid{panels.size()};
    const bool is_amplitude = summary.profile_axis != "feature";
    const std::string unit = is_amplitude ? "amplitude (LSB)" : "value";
    std::string text = axes_style() + "unset key\n";
    const std::size_t shown =
        panels.classes.empty() ? 0 : shown_values(panels, summary.profile_axis == "range bin");
    for (std::size_t i = 0; i < panels.classes.size(); ++i)
        text += profile_data(*panels.classes[i], i, shown, is_amplitude);
    text += "set multiplot\n";
    const Canvas canvas = grid.canvas();
    const std::string heading = canvas.label(
        {.text = title, .x_px = Grid::left_px, .y_px = 12, .size_px = 13.0, .bold = true});
    for (std::size_t i = 0; i < panels.classes.size(); ++i) {
        text +=
            panel_frame(grid, i,
                        format("{} ({})", panels.classes[i]->name, panels.classes[i]->n_frames),
                        summary.profile_axis + ", " + unit) +
            (i == 0 ? heading : "") +
            format("set xrange [0:{}]\nset yrange [{}:{}]\n", std::max<std::size_t>(1, shown - 1),
                   is_amplitude ? "0" : "*<0", highest(panels, shown)) +
            profile_plot(*panels.classes[i], i);
    }
    for (std::size_t i = 0; i < panels.quantities.size(); ++i) {
        const FrameQuantity& quantity = *panels.quantities[i];
        const std::size_t at = panels.classes.size() + i;
        text += panel_frame(grid, at, quantity.name,
                            format("{} ({}), frames", quantity.name, quantity.unit)) +
                (at == 0 ? heading : "") + histogram_panel(quantity, i);
    }
    return text + "unset multiplot\n";
}

std::string csv_of(const Panels& panels) {
    CsvTable table({"panel", "x", "mean_or_count", "sd"});
    for (const ClassSummary* each : panels.classes)
        for (std::size_t k = 0; k < each->profile_mean.size(); ++k)
            table.add({each->name, format("{}", k), format("{}", each->profile_mean[k]),
                       format("{}", each->profile_sd[k])});
    for (const FrameQuantity* each : panels.quantities) {
        const Histogram histogram = histogram_of(each->values, histogram_intervals);
        for (std::size_t i = 0; i < histogram.counts.size(); ++i)
            table.add({format("{} ({})", each->name, each->unit),
                       format("{}", histogram.first + static_cast<double>(i) * histogram.width),
                       format("{}", histogram.counts[i]), ""});
    }
    return table.text();
}

}  // namespace

Figure dataset_figure(const std::string& name, const DatasetSummary& summary) {
    const Panels panels = panels_of(summary);
    if (panels.size() == 0)
        throw InputError(name + ": nothing to draw: no frames, or none with a profile");
    const Grid grid{panels.size()};
    const std::string title =
        format("{}: {} frames, {} sessions", name, summary.n_frames, summary.sessions.size());
    return {.name = "dataset",
            .title = title,
            .description = format(
                "Small panels: mean profile of each of {} classes with a band of one standard "
                "deviation and single frames, then {} distributions over all frames.",
                panels.classes.size(), panels.quantities.size()),
            .script = script_of(title, summary, panels),
            .csv = csv_of(panels),
            .width_in = grid.canvas().width_in(),
            .height_in = grid.canvas().height_in()};
}

}  // namespace specula
