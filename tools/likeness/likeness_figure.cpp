#include "tools/likeness/likeness_figure.hpp"

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {

namespace {

constexpr double row_px = 232.0, panel_height_px = 150.0, head_px = 88.0, panel_width_px = 224.0;
constexpr double column_px = 300.0, left_px = 72.0;

struct Panel {
    const char* name;
    const char* below;
    const char* beside;
    const char* settings;
};
constexpr Panel panels[] = {
    {"start", "sample", "mean code (LSB)", "set xrange [0:24]\nset yrange [*:*]\n"},
    {"chirp", "sample", "mean code (LSB)", "set xrange [0:*]\nset yrange [*:*]\n"},
    {"spectrum", "range bin", "dB over 1 LSB", "set xrange [0:*]\nset yrange [-20:*]\n"},
    {"noise", "range bin", "noise (LSB rms)", "set xrange [0:*]\nset yrange [0.1:*]\nset logscale y\n"},
    {"histogram", "code (LSB)", "share of codes",
     "unset logscale y\nset xrange [*:*]\nset yrange [0:*]\n"},
};

constexpr std::size_t histogram_panel = 4;

Canvas canvas_for(std::size_t n_rx) {
    return {.width_px = left_px + 5.0 * column_px - 60.0,
            .height_px = head_px + static_cast<double>(n_rx) * row_px};
}

const LikenessCurves::Pair& pair_of(const LikenessCurves& curves, std::size_t panel) {
    const LikenessCurves::Pair* pairs[] = {&curves.mean_chirp, &curves.mean_chirp, &curves.spectrum_db,
                                           &curves.noise_lsb, &curves.histogram};
    return *pairs[panel];
}

double abscissa(const LikenessCurves& curves, std::size_t panel, std::size_t i) {
    const double step = static_cast<double>(i);
    if (panel != histogram_panel) return step;
    return curves.histogram_begin_lsb + (step + 0.5) * curves.histogram_step_lsb;
}

std::string block(const LikenessCurves& curves, std::size_t panel, const std::string& name) {
    const auto& pair = pair_of(curves, panel);
    std::string text = "$" + name + " << END\n";
    for (std::size_t i = 0; i < pair.recorded.size(); ++i)
        text += format("{:.6g} {:.6g} {:.6g}\n", abscissa(curves, panel, i), pair.recorded[i],
                       pair.simulated[i]);
    return text + "END\n";
}

/// Marks of the histogram's codes far enough apart for their numbers.
std::string code_marks(const LikenessCurves& curves) {
    const double apart =
        0.4 * curves.histogram_step_lsb * static_cast<double>(curves.histogram.recorded.size());
    double step = 1.0;
    while (10.0 * step <= apart) step *= 10.0;
    const double factor = apart >= 5.0 * step ? 5.0 : apart >= 2.0 * step ? 2.0 : 1.0;
    return format("set xtics {}\n", factor * step);
}

std::string panel_script(const Canvas& canvas, const LikenessCurves& curves, std::size_t rx,
                         std::size_t panel) {
    const double left = left_px + static_cast<double>(panel) * column_px;
    const double top = head_px + static_cast<double>(rx) * row_px;
    const PixelBox box{
        .left = left, .top = top, .right = left + panel_width_px, .bottom = top + panel_height_px};
    const Panel& what = panels[panel];
    const auto label = [&](const std::string& text, double x_px, double y_px, bool upwards) {
        return canvas.label({.text = text,
                             .x_px = x_px,
                             .y_px = y_px,
                             .align = "center",
                             .colour = soft_ink,
                             .upwards = upwards});
    };
    return std::string("unset label\n") + what.settings +
           (panel == histogram_panel ? code_marks(curves) : "set xtics autofreq\n") + canvas.frame(box) +
           label(what.below, 0.5 * (box.left + box.right), box.bottom + 38.0, false) +
           label(what.beside, box.left - 52.0, 0.5 * (box.top + box.bottom), true) +
           canvas.label({.text = format("RX {}", rx),
                         .x_px = box.left + 6.0,
                         .y_px = box.top - 8.0,
                         .bold = true}) +
           format(
               "plot $p{0}_{1} using 1:2 with lines linewidth 1.8 linecolor rgb '{2}', "
               "'' using 1:3 with lines linewidth 1.4 dashtype (6,3) linecolor rgb '{3}'\n",
               rx, panel, series_colour(0), series_colour(2));
}

std::string csv(const Likeness& likeness) {
    CsvTable table({"rx", "panel", "x", "recorded", "simulated"});
    for (std::size_t rx = 0; rx < likeness.curves.size(); ++rx)
        for (std::size_t panel = 0; panel < std::size(panels); ++panel) {
            const LikenessCurves& curves = likeness.curves[rx];
            const auto& pair = pair_of(curves, panel);
            for (std::size_t i = 0; i < pair.recorded.size(); ++i)
                table.add({format("{}", rx), panels[panel].name,
                           format("{:.6g}", abscissa(curves, panel, i)),
                           format("{:.6g}", pair.recorded[i]),
                           format("{:.6g}", pair.simulated[i])});
        }
    return table.text();
}

}  // namespace

Figure likeness_figure(const Likeness& likeness, const std::string& title) {
    const Canvas canvas = canvas_for(likeness.curves.size());
    std::string script = axes_style();
    for (std::size_t rx = 0; rx < likeness.curves.size(); ++rx)
        for (std::size_t panel = 0; panel < std::size(panels); ++panel)
            script += block(likeness.curves[rx], panel, format("p{}_{}", rx, panel));
    const PixelBox whole{.left = left_px,
                         .top = head_px - 26.0,
                         .right = canvas.width_px,
                         .bottom = canvas.height_px};
    const auto key = legend_row(canvas, left_px + 920.0, 22.0,
                                {{.label = "recorded",
                                  .colour = series_colour(0),
                                  .marker = Marker::line_point,
                                  .point_size = 0.0},
                                 {.label = "simulated (dashed)",
                                  .colour = series_colour(2),
                                  .marker = Marker::line_point,
                                  .point_size = 0.0}});
    script += "set multiplot\n";
    for (std::size_t rx = 0; rx < likeness.curves.size(); ++rx)
        for (std::size_t panel = 0; panel < std::size(panels); ++panel) {
            std::string one = panel_script(canvas, likeness.curves[rx], rx, panel);
            if (rx == 0 && panel == 0) {
                const std::string head =
                    canvas.heading(whole, title, format("{} chirps each", likeness.n_chirps)) +
                    key.commands;
                one.insert(one.find("plot "), head);
            }
            script += one;
        }
    script += "unset multiplot\n";
    return {.name = "likeness",
            .title = title,
            .description =
                "Recorded and simulated chirps side by side, a row for each receiver: "
                "start of the mean chirp, mean chirp, amplitude spectrum, noise per bin and histogram of codes.",
            .script = script,
            .csv = csv(likeness),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace specula
