#include "tools/report/reliability_grid.hpp"

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/panel_grid.hpp"

namespace specula {
namespace {

constexpr std::size_t answer_series = 0, count_series = 6;
constexpr double bar_half_width = 2.2;  ///< percent of confidence

double n_frames(const ReliabilityPanel& panel) {
    double n = 0.0;
    for (const ReliabilityPoint& point : panel.points) n += static_cast<double>(point.n);
    return n;
}

/// (confidence, right, low, high, share of frames), percent.
std::string grid_block(const ReliabilityPanel& panel, std::size_t index) {
    const double n = n_frames(panel);
    std::string text = format("$r{} << END\n", index);
    for (const ReliabilityPoint& point : panel.points)
        text += format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", 100.0 * point.confidence,
                       100.0 * point.accuracy.mean, 100.0 * point.accuracy.low,
                       100.0 * point.accuracy.high, 100.0 * static_cast<double>(point.n) / n);
    return text + "NaN NaN NaN NaN NaN\nEND\n";
}

std::string grid_panel(const ReliabilityGrid& content, const PanelGrid& grid, std::size_t index) {
    const ReliabilityPanel& panel = content.panels[index];
    const Canvas canvas = grid.canvas();
    const PixelBox box = grid.panel(index);
    const std::string title =
        format("{} (calibration error {})", panel.title, percent_text(panel.calibration_error));
    const bool is_left = index % grid.n_columns() == 0;
    return format("unset label\nset format y '{}'\nset format x '{}'\n", is_left ? "%g" : "",
                  grid.is_lowest(index) ? "%g" : "") +
           canvas.frame(box) +
           canvas.label({.text = title, .x_px = box.left, .y_px = box.top - 12.0}) +
           grid_block(panel, index) +
           format(
               "plot $r{0} using 1:(0):($1-{1}):($1+{1}):(0):5 with boxxyerror fillstyle solid 1 "
               "noborder fillcolor rgb '{2}', x with lines dashtype (4,3) linecolor rgb '{3}', "
               "$r{0} using 1:2:3:4 with yerrorbars pointtype {4} pointsize 0.5 linewidth 1.3 "
               "linecolor rgb '{5}'\n",
               index, bar_half_width, faint(series_colour(count_series), 0.55), soft_ink,
               series_point(answer_series), series_colour(answer_series));
}

std::string grid_script(const ReliabilityGrid& content, const PanelGrid& grid) {
    const Canvas canvas = grid.canvas();
    const double middle = 0.5 * canvas.height_px;
    // Labels of the whole figure come first: each panel clears what stands before it.
    std::string text =
        axes_style() +
        format("set grid ytics xtics\nset errorbars 0.5\nset xrange [{}:102]\n"
               "set yrange [0:102]\nset xtics 20\nset ytics 20\nset multiplot\n",
               100.0 * content.least_confidence - 2.0 * bar_half_width);
    std::string whole =
        legend_row(canvas, PanelGrid::left_px, 14.0,
                   {{.label = "right answers, 95\u00a0% interval over worlds",
                     .colour = series_colour(answer_series),
                     .marker = Marker::line_point,
                     .point_type = series_point(answer_series)},
                    {.label = "share of the frames",
                     .colour = series_colour(count_series),
                     .marker = Marker::patch}})
            .commands +
        canvas.label({.text = "right answers, share of frames (%)",
                      .x_px = 14.0,
                      .y_px = middle,
                      .align = "center",
                      .colour = soft_ink,
                      .upwards = true}) +
        canvas.label({.text = "confidence (%)",
                      .x_px = 0.5 * canvas.width_px,
                      .y_px = canvas.height_px - 12.0,
                      .align = "center",
                      .colour = soft_ink});
    for (std::size_t i = 0; i < content.panels.size(); ++i) {
        std::string panel = grid_panel(content, grid, i);
        const std::string clear = "unset label\n";
        if (i == 0) panel = whole + panel.substr(clear.size());
        text += panel + "unset object\nunset arrow\n";
    }
    return text + "unset multiplot\n";
}

std::string grid_csv(const ReliabilityGrid& content) {
    CsvTable table({"condition", "n_frames", "confidence_share", "accuracy_share", "low_share",
                    "high_share"});
    for (const ReliabilityPanel& panel : content.panels)
        for (const ReliabilityPoint& point : panel.points)
            table.add({panel.title, format("{}", point.n), format("{:.6g}", point.confidence),
                       format("{:.6g}", point.accuracy.mean), format("{:.6g}", point.accuracy.low),
                       format("{:.6g}", point.accuracy.high)});
    return table.text();
}

}  // namespace

Figure reliability_grid(const std::string& name, const ReliabilityGrid& content) {
    SPECULA_EXPECT(!content.panels.empty());
    const PanelGrid grid{.n_panels = content.panels.size(), .title_px = PanelGrid::line_px};
    std::string description = "Share of right answers over confidence; calibration error: ";
    for (const ReliabilityPanel& panel : content.panels)
        description += format("{}{} {}", &panel == &content.panels.front() ? "" : "; ",
                              panel.title, percent_text(panel.calibration_error));
    return {.name = name,
            .title = "Reliability",
            .description = description + ".",
            .script = grid_script(content, grid),
            .csv = grid_csv(content),
            .width_in = grid.canvas().width_in(),
            .height_in = grid.canvas().height_in()};
}

}  // namespace specula
