#include "tools/report/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/report/gnuplot.hpp"

namespace specula {

std::string Canvas::at(double x_px, double y_px) const {
    return format("screen {:.6f}, screen {:.6f}", x_px / width_px, 1.0 - y_px / height_px);
}

std::string Canvas::frame(const PixelBox& box) const {
    return format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
        "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n",
        box.left / width_px, box.right / width_px, 1.0 - box.top / height_px,
        1.0 - box.bottom / height_px);
}

std::string Canvas::label(const Text& text) const {
    return format("set label {} at {} {}{} {} textcolor rgb '{}' front\n",
                  gnuplot_quoted(text.text), at(text.x_px, text.y_px), text.align,
                  text.upwards ? " rotate by 90" : "", font_clause(text.size_px, text.bold),
                  text.colour);
}

std::string Canvas::star(double x_px, double y_px) const {
    std::string path;
    for (int corner = 0; corner <= 10; ++corner) {
        const double radius_px = corner % 2 == 0 ? 7.5 : 3.1;
        const double angle = pi * (0.5 + corner / 5.0);
        path += (corner == 0 ? "from " : " to ") +
                at(x_px + radius_px * std::cos(angle), y_px - radius_px * std::sin(angle));
    }
    return format("set object polygon {} front fillstyle solid noborder fillcolor rgb '{}'\n", path,
                  ink);
}

std::string Canvas::heading(const PixelBox& box, const std::string& title,
                            const std::string& second_line) const {
    constexpr double title_px = 13.0, edge_px = 6.0;
    const double needed =
        std::max(text_width_px(title, title_px, true), text_width_px(second_line)) + edge_px;
    const double x = std::max(edge_px, std::min(box.left, width_px - needed));
    return label({.text = title, .x_px = x, .y_px = 14, .size_px = title_px, .bold = true}) +
           label({.text = second_line, .x_px = x, .y_px = 34, .colour = soft_ink});
}

std::string Canvas::axis_titles(const PixelBox& box, const std::string& below,
                                const std::string& beside) const {
    return label({.text = below,
                  .x_px = 0.5 * (box.left + box.right),
                  .y_px = height_px - 12,
                  .align = "center",
                  .colour = soft_ink}) +
           label({.text = beside,
                  .x_px = 10,
                  .y_px = 0.5 * (box.top + box.bottom),
                  .align = "center",
                  .colour = soft_ink,
                  .upwards = true});
}

double text_width_px(std::string_view utf8, double size_px, bool bold) {
    const auto n_characters =
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; });
    return (bold ? 0.6 : 0.51) * size_px * static_cast<double>(n_characters);
}

std::vector<std::string> wrapped(const std::string& text, double width_px, bool bold) {
    std::vector<std::string> lines(1);
    for (std::size_t begin = 0, end = 0; begin <= text.size(); begin = end + 1) {
        end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        std::string& line = lines.back();
        if (line.empty())
            line = word;
        else if (text_width_px(line + " " + word, figure_font_px, bold) <= width_px)
            line += " " + word;
        else
            lines.push_back(word);
    }
    return lines;
}

namespace {

constexpr double marker_px = 22.0, gap_px = 8.0, between_px = 26.0;

std::string marker(const Canvas& canvas, double x_px, double y_px, const LegendEntry& entry) {
    if (entry.marker == Marker::patch)
        return format(
            "set object rectangle from {} to {} front fillstyle transparent solid 0.28 "
            "border linecolor rgb '{}' fillcolor rgb '{}' linewidth 1.2\n",
            canvas.at(x_px, y_px + 5.5), canvas.at(x_px + marker_px, y_px - 5.5), entry.colour,
            entry.colour);
    std::string commands;
    if (entry.marker == Marker::line_point)
        commands = format("set arrow from {} to {} nohead front linewidth 1.3 linecolor rgb '{}'\n",
                          canvas.at(x_px, y_px), canvas.at(x_px + marker_px, y_px), entry.colour);
    return commands + format(
                          "set label '' at {} point pointtype {} pointsize {} linecolor rgb '{}' "
                          "front\n",
                          canvas.at(x_px + 0.5 * marker_px, y_px), entry.point_type,
                          entry.point_size, entry.colour);
}

}  // namespace

std::vector<LegendEntry> interval_legend(const std::vector<std::string>& series) {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < series.size(); ++i)
        entries.push_back({.label = series[i],
                           .colour = series_colour(2 * i),
                           .marker = Marker::line_point,
                           .point_type = series_point(2 * i),
                           .point_size = 0.7});
    return entries;
}

Legend legend_row(const Canvas& canvas, double x_px, double y_px,
                  const std::vector<LegendEntry>& entries) {
    Legend legend{.commands = {}, .end_px = x_px};
    for (const LegendEntry& entry : entries) {
        const double text_px = legend.end_px + marker_px + gap_px;
        legend.commands += marker(canvas, legend.end_px, y_px, entry) +
                           canvas.label({.text = entry.label, .x_px = text_px, .y_px = y_px});
        legend.end_px = text_px + text_width_px(entry.label) + between_px;
    }
    return legend;
}

}  // namespace specula
