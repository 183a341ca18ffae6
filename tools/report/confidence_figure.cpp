#include "tools/report/confidence_figure.hpp"

#include <numeric>

#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/number_text.hpp"

namespace specula {
namespace {

constexpr Canvas canvas{.width_px = 480, .height_px = 412};
constexpr PixelBox area{.left = 56, .top = 52, .right = 464, .bottom = 356};
constexpr std::size_t correct_series = 0, wrong_series = 2;
constexpr std::size_t histogram_bins = ConfidenceHistogram::n_bins;

using Counts = std::array<std::int64_t, histogram_bins>;

std::int64_t total(const Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

double share(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

double edge(std::size_t bin) {
    return static_cast<double>(bin) / static_cast<double>(histogram_bins);
}

/// Outline of the histogram, both corners of every bin: (confidence, percent of the group).
std::string outline(std::string_view block, const Counts& counts) {
    std::string text = format("${} << END\n0 0\n", block);
    for (std::size_t bin = 0; bin < histogram_bins; ++bin)
        for (const double x : {edge(bin), edge(bin + 1)})
            text += format("{} {}\n", x, 100.0 * share(counts[bin], total(counts)));
    return text + "1 0\nEND\n";
}

std::string second_line(const ConditionReport& condition) {
    return format("mean confidence {}, 95\u00a0% interval {}",
                  percent_text(condition.mean_confidence.mean),
                  range_text(condition.mean_confidence));
}

std::string legends(std::int64_t n_correct, std::int64_t n_wrong) {
    const auto entry = [&](std::string_view group, std::int64_t n, std::size_t series) {
        return LegendEntry{
            .label = format("{}: {} of frames ({})", group,
                            percent_text(share(n, n_correct + n_wrong)), count_text(n)),
            .colour = series_colour(series),
            .marker = Marker::patch};
    };
    const double x = area.left + 14, y = area.top + 18;
    return legend_row(canvas, x, y, {entry("correct", n_correct, correct_series)}).commands +
           legend_row(canvas, x, y + 20, {entry("wrong", n_wrong, wrong_series)}).commands;
}

std::string curves() {
    const auto filled = [](std::string_view block, std::size_t series) {
        return format(
            "${} using 1:2 with filledcurves y=0 fillstyle transparent solid 0.28 noborder "
            "linecolor rgb '{}'",
            block, series_colour(series));
    };
    const auto line = [](std::string_view block, std::size_t series) {
        return format("${} using 1:2 with lines linewidth 1.5 linecolor rgb '{}'", block,
                      series_colour(series));
    };
    return "plot " + filled("correct", correct_series) + ", " + filled("wrong", wrong_series) +
           ", " + line("correct", correct_series) + ", " + line("wrong", wrong_series) + "\n";
}

std::string script(const ConditionReport& condition) {
    const auto& [correct, wrong] = condition.confidence;
    const std::size_t n_classes = condition.confusion.n;
    const double lowest = n_classes > 0 ? edge(histogram_bins / n_classes) : 0.0;
    return axes_style() +
           "set grid ytics noxtics\nset xtics 0.2\nset mxtics 2\nset format x '%.1f'\n" +
           format("set xrange [{}:1]\nset yrange [0:*]\n", lowest) + canvas.frame(area) +
           canvas.heading(area, condition.title, second_line(condition)) +
           canvas.axis_titles(area, "confidence (largest softmax probability)",
                              "share of the group (%)") +
           legends(total(correct), total(wrong)) + outline("correct", correct) +
           outline("wrong", wrong) + curves();
}

std::string csv(const ConditionReport& condition) {
    const auto& [correct, wrong] = condition.confidence;
    CsvTable table({"condition", "confidence_low", "confidence_high", "n_correct", "n_wrong",
                    "share_of_correct", "share_of_wrong"});
    for (std::size_t bin = 0; bin < histogram_bins; ++bin)
        table.add({condition.name, format("{}", edge(bin)), format("{}", edge(bin + 1)),
                   format("{}", correct[bin]), format("{}", wrong[bin]),
                   format("{}", share(correct[bin], total(correct))),
                   format("{}", share(wrong[bin], total(wrong)))});
    return table.text();
}

std::string description(const ConditionReport& condition) {
    const auto& [correct, wrong] = condition.confidence;
    const std::int64_t n_all = total(correct) + total(wrong);
    return format(
        "Two histograms of the largest softmax probability: {} of the frames are classified "
        "correctly, of which {} lie in the highest bin; of the wrong ones {} do.",
        percent_text(share(total(correct), n_all)),
        percent_text(share(correct.back(), total(correct))),
        percent_text(share(wrong.back(), total(wrong))));
}

}  // namespace

Figure confidence_figure(const std::string& name, const ConditionReport& condition) {
    return {.name = name,
            .title = "Confidence distribution: " + condition.title,
            .description = description(condition),
            .script = script(condition),
            .csv = csv(condition),
            .width_in = canvas.width_in(),
            .height_in = canvas.height_in()};
}

}  // namespace specula
