#include "tools/report/reliability_figure.hpp"

#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/number_text.hpp"

namespace specula {
namespace {

constexpr Canvas reliability_canvas{.width_px = 480, .height_px = 482};
constexpr PixelBox reliability_area{.left = 56, .top = 52, .right = 464, .bottom = 356};
constexpr std::size_t raw_series = 0, scaled_series = 2;
constexpr double bar_height = 18.0;  // percent of the axis that the fullest bin's bar takes

/// (confidence, right), percent.
std::string curve_block(std::string_view block, const Reliability& reliability) {
    std::string text = format("${} << END\n", block);
    for (const ReliabilityBin& bin : reliability.bins)
        if (bin.n > 0) text += format("{} {}\n", 100.0 * bin.confidence, 100.0 * bin.accuracy);
    return text + "END\n";
}

/// (low, high, height) of a bar per bin along the foot: how many examples it holds.
std::string count_block(const Reliability& reliability) {
    std::size_t most = 1;
    for (const ReliabilityBin& bin : reliability.bins) most = std::max(most, bin.n);
    const auto n_bins = static_cast<double>(reliability.bins.size());
    std::string text = "$counts << END\n";
    for (std::size_t b = 0; b < reliability.bins.size(); ++b)
        text += format(
            "{} {} {}\n", 100.0 * static_cast<double>(b) / n_bins,
            100.0 * static_cast<double>(b + 1) / n_bins,
            bar_height * static_cast<double>(reliability.bins[b].n) / static_cast<double>(most));
    return text + "END\n";
}

LegendEntry curve_entry(const std::string& label, const Reliability& reliability,
                        std::size_t series) {
    return {.label = format("{}, calibration error {}", label,
                            percent_text(reliability.expected_calibration_error)),
            .colour = series_colour(series),
            .marker = Marker::line_point,
            .point_type = series_point(series)};
}

std::string legends(const ReliabilityCurves& curves) {
    const double x = reliability_area.left, y = reliability_area.bottom + 74;  // below the axis
    std::string text =
        legend_row(reliability_canvas, x, y, {curve_entry("as trained", curves.raw, raw_series)})
            .commands;
    std::size_t most = 0;
    for (const ReliabilityBin& bin : curves.raw.bins) most = std::max(most, bin.n);
    const double below = curves.temperature == 1.0 ? 20.0 : 40.0;
    text += legend_row(reliability_canvas, x, y + below,
                       {{.label = format("frames as trained in the bin; the highest bar: {}", most),
                         .colour = rule_colour,
                         .marker = Marker::patch}})
                .commands;
    if (curves.temperature == 1.0) return text;
    const std::string label = format("temperature {}", fixed_text(curves.temperature, 2));
    return text + legend_row(reliability_canvas, x, y + 20,
                             {curve_entry(label, curves.scaled, scaled_series)})
                      .commands;
}

/// Above the legend, which has the foot of the canvas.
std::string axis_below() {
    return reliability_canvas.label({.text = "confidence (%)",
                                     .x_px = 0.5 * (reliability_area.left + reliability_area.right),
                                     .y_px = reliability_area.bottom + 44,
                                     .align = "center",
                                     .colour = soft_ink});
}

std::string plot(const ReliabilityCurves& curves) {
    const auto line = [](std::string_view block, std::size_t series) {
        return format(
            ", ${} using 1:2 with linespoints linewidth 1.6 pointtype {} pointsize 0.8 "
            "linecolor rgb '{}'",
            block, series_point(series), series_colour(series));
    };
    std::string text = format(
        "plot $counts using 1:(0):1:2:(0):3 with boxxyerror fillstyle solid 1 noborder "
        "fillcolor rgb '{}', x with lines dashtype (4,3) linecolor rgb '{}'",
        rule_colour, soft_ink);
    text += line("raw", raw_series);
    if (curves.temperature != 1.0) text += line("scaled", scaled_series);
    return text + "\n";
}

std::string csv(const ReliabilityCurves& curves) {
    CsvTable table({"curve", "temperature", "bin", "n_frames", "confidence_share", "accuracy_share"});
    const auto add = [&](const std::string& curve, double temperature,
                         const Reliability& reliability) {
        for (std::size_t b = 0; b < reliability.bins.size(); ++b) {
            const ReliabilityBin& bin = reliability.bins[b];
            table.add({curve, format("{}", temperature), format("{}", b), format("{}", bin.n),
                       format("{}", bin.confidence), format("{}", bin.accuracy)});
        }
    };
    add("raw", 1.0, curves.raw);
    if (curves.temperature != 1.0) add("scaled", curves.temperature, curves.scaled);
    return table.text();
}

}  // namespace

Figure reliability_figure(const std::string& name, const std::string& title,
                          const ReliabilityCurves& curves) {
    const std::string second_line =
        format("mean confidence {}, right {}", percent_text(curves.raw.mean_confidence),
               percent_text(curves.raw.accuracy));
    return {.name = name,
            .title = "Reliability: " + title,
            .description = format(
                "Share of right answers over confidence. {}; the expected calibration error over "
                "{} bins is {}. Bars along the foot show how many frames each bin holds.",
                second_line, curves.raw.bins.size(),
                percent_text(curves.raw.expected_calibration_error)),
            .script = axes_style() + "set xrange [0:100]\nset yrange [0:100]\nset xtics 20\n" +
                      "set ytics 20\n" + reliability_canvas.frame(reliability_area) +
                      reliability_canvas.heading(reliability_area, title, second_line) +
                      reliability_canvas.axis_titles(reliability_area, "", "right answers (%)") +
                      axis_below() + legends(curves) + count_block(curves.raw) +
                      curve_block("raw", curves.raw) + curve_block("scaled", curves.scaled) +
                      plot(curves),
            .csv = csv(curves),
            .width_in = reliability_canvas.width_in(),
            .height_in = reliability_canvas.height_in()};
}

}  // namespace specula
