#include "tools/validate/error_figure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/canvas.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/report/gnuplot.hpp"

namespace specula {
namespace {

constexpr Canvas canvas{.width_px = 912.0, .height_px = 360.0};
constexpr PixelBox area{.left = 76.0, .top = 62.0, .right = 900.0, .bottom = 304.0};
constexpr double least_share = 1e-7, most_share = 1e3, legend_px = 34.0;
constexpr std::size_t passed_series = 0, failed_series = 2, unknown_series = 6;
constexpr std::size_t all_series[] = {passed_series, failed_series, unknown_series};

/// A point as it is drawn.
struct Dot {
    double x;
    double share;
    std::size_t series;
};

double drawn_share(double share) {
    return std::clamp(share, least_share, most_share);
}

/// Points of one case stand side by side, cases half a point's gap apart at least.
struct Places {
    std::vector<Dot> dots;
    std::vector<double> middle;  ///< (case)
    std::vector<double> border;  ///< between cases
    double end = 0.0;
};

Places places_of(const std::vector<const CaseVerdict*>& cases) {
    Places places;
    // A case has the same width as any other: one of 256 points must not hide one of 2.
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& points = cases[i]->points;
        const double step = 1.0 / static_cast<double>(points.size() + 1);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double x = static_cast<double>(i) + step * static_cast<double>(k + 1);
            const Verdict verdict = points[k].verdict();
            const Quantity* worst = points[k].worst();
            if (verdict == Verdict::not_computable)
                places.dots.push_back({x, most_share, unknown_series});
            else if (worst != nullptr)
                places.dots.push_back({x, drawn_share(worst->share()),
                                       verdict == Verdict::fail ? failed_series : passed_series});
        }
        places.middle.push_back(static_cast<double>(i) + 0.5);
        if (i > 0) places.border.push_back(static_cast<double>(i));
    }
    places.end = static_cast<double>(cases.size());
    return places;
}

std::string blocks(const Places& places) {
    std::string text;
    for (const std::size_t series : all_series) {
        text += format("$s{} << END\n", series);
        for (const Dot& dot : places.dots)
            if (dot.series == series) text += format("{} {}\n", dot.x, dot.share);
        text += "NaN NaN\nEND\n";
    }
    return text;
}

std::string axes(const std::vector<const CaseVerdict*>& cases, const Places& places) {
    std::string tics;
    for (std::size_t i = 0; i < cases.size(); ++i)
        tics +=
            format("{}{} {}", i > 0 ? ", " : "", gnuplot_quoted(cases[i]->kind), places.middle[i]);
    std::string text = format(
        "set xrange [0:{}]\nset xtics ({}) scale 0\nset logscale y\nset format y '%g'\n"
        "set yrange [{}:{}]\nset ytics 10\nset mytics 1\nset grid ytics noxtics\n",
        places.end, tics, least_share * 0.5, most_share * 2.0);
    for (const double x : places.border)
        text += format(
            "set arrow from {0}, graph 0 to {0}, graph 1 nohead back linewidth 0.8 linecolor rgb "
            "'{1}'\n",
            x, rule_colour);
    return text + format(
                      "set arrow from graph 0, first 1 to graph 1, first 1 nohead back dashtype "
                      "(6,4) linewidth 1.2 linecolor rgb '{}'\n",
                      soft_ink);
}

/// Above the right end of the line at 1.
std::string tolerance_label() {
    const double decades = std::log10(most_share * 2.0) - std::log10(least_share * 0.5);
    const double up = -std::log10(least_share * 0.5) / decades;
    return canvas.label({.text = "tolerance",
                         .x_px = area.right - 4,
                         .y_px = area.bottom - (area.bottom - area.top) * up - 8,
                         .align = "right",
                         .size_px = 11,
                         .colour = soft_ink});
}

std::string curves() {
    std::string text;
    for (const std::size_t series : all_series)
        text += format(
            "{}$s{} using 1:2 with points pointtype {} pointsize 0.45 linecolor rgb '{}'",
            text.empty() ? "plot " : ", ", series, series_point(series), series_colour(series));
    return text + "\n";
}

std::string legend() {
    const auto entry = [](const char* label, std::size_t series) {
        return LegendEntry{.label = label,
                           .colour = series_colour(series),
                           .marker = Marker::point,
                           .point_type = series_point(series),
                           .point_size = 0.6};
    };
    return legend_row(canvas, area.left, legend_px,
                      {entry("within tolerance", passed_series), entry("beyond", failed_series),
                       entry("cannot be computed", unknown_series)})
        .commands;
}

std::string csv(const std::vector<const CaseVerdict*>& cases) {
    CsvTable table({"case", "point", "verdict", "quantity", "error", "tolerance", "unit",
                    "error_over_tolerance"});
    for (const CaseVerdict* each : cases)
        for (std::size_t i = 0; i < each->points.size(); ++i) {
            const PointVerdict& point = each->points[i];
            const Quantity* worst = point.worst();
            const std::string verdict = verdict_name(point.verdict());
            if (worst == nullptr)
                table.add({each->id, format("{}", i), verdict, "", "", "", "", ""});
            else
                table.add({each->id, format("{}", i), verdict, worst->name,
                           format("{:.6g}", worst->error), format("{:.6g}", worst->tolerance),
                           worst->unit, format("{:.6g}", worst->share())});
        }
    return table.text();
}

}  // namespace

Figure error_figure(const std::string& name, const std::string& title,
                    const std::vector<const CaseVerdict*>& cases) {
    SPECULA_EXPECT(!cases.empty());
    const Places places = places_of(cases);
    std::string description = "Largest error over tolerance of each point. ";
    for (const CaseVerdict* each : cases)
        description += format("{}: {}. ", each->id, verdict_name(each->verdict()));
    return {
        .name = name,
        .title = title,
        .description = description,
        .script = axes_style() + blocks(places) + axes(cases, places) + canvas.frame(area) +
                  canvas.label(
                      {.text = title, .x_px = area.left, .y_px = 14, .size_px = 13, .bold = true}) +
                  tolerance_label() + legend() +
                  canvas.axis_titles(area, "case, its points side by side", "error / tolerance") +
                  curves(),
        .csv = csv(cases),
        .width_in = canvas.width_in(),
        .height_in = canvas.height_in()};
}

}  // namespace specula
