#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/report/figure_style.hpp"

namespace specula {

/// Pixels from the left and top edges of a figure.
struct PixelBox {
    double left, top, right, bottom;
};

/// A text somewhere on the figure; `y_px` is its middle.
struct Text {
    std::string text;
    double x_px, y_px;
    std::string_view align = "left";  ///< left, center, right
    double size_px = figure_font_px;
    bool bold = false;
    std::string_view colour = ink;
    bool upwards = false;
};

enum class Marker { point, line_point, patch };

struct LegendEntry {
    std::string label;
    std::string_view colour;
    Marker marker = Marker::point;
    int point_type = 7;
    double point_size = 0.8;
};

/// Legend of series that stand beside each other as means with intervals, in colours well apart.
std::vector<LegendEntry> interval_legend(const std::vector<std::string>& series);

/// Places things by pixel. gnuplot's own `character` unit and its legend differ between the SVG and
/// the PNG terminal; pixels make both look the same.
struct Canvas {
    double width_px, height_px;

    double width_in() const { return width_px / 96.0; }
    double height_in() const { return height_px / 96.0; }
    /// "screen x, screen y"
    std::string at(double x_px, double y_px) const;
    /// Margins that put the plotting area into `box`.
    std::string frame(const PixelBox& box) const;
    std::string label(const Text& text) const;
    /// A five-pointed star of our own: no gnuplot point type is one, and fonts need not have one.
    std::string star(double x_px, double y_px) const;
    /// Title and second line above the plotting area, flush with its left edge unless too long.
    std::string heading(const PixelBox& box, const std::string& title,
                        const std::string& second_line) const;
    /// Axis titles: below the plotting area and left of the figure.
    std::string axis_titles(const PixelBox& box, const std::string& below,
                            const std::string& beside) const;
};

/// A row of legend entries from (x_px, y_px); widths are estimated from the number of characters.
struct Legend {
    std::string commands;
    double end_px;  ///< where a further entry would begin
};
Legend legend_row(const Canvas& canvas, double x_px, double y_px,
                  const std::vector<LegendEntry>& entries);

/// Roughly how wide a text is drawn.
double text_width_px(std::string_view utf8, double size_px = figure_font_px, bool bold = false);

/// The text in lines that fit, broken at spaces.
std::vector<std::string> wrapped(const std::string& text, double width_px, bool bold = false);

}  // namespace specula
