#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace specula {

/// A colour that means something. In the HTML report it becomes a CSS variable, so that it can be
/// another one on a dark ground; everywhere else it is what `light` says.
struct ColourRole {
    std::string_view variable;
    std::string_view light;  ///< in figures, and on white
    std::string_view dark;   ///< on the dark page
};

/// Series colours keep apart in hue and lightness for the common colour-vision deficiencies;
/// figures add marker shapes all the same.
inline constexpr std::array<ColourRole, 10> colour_roles{{
    {"--ink", "#000000", "#e7e5e1"},
    {"--soft-ink", "#4d4d4d", "#b1aea8"},
    {"--rule", "#e2e2e2", "#37383b"},
    {"--series-1", "#264b96", "#7c98ff"},
    {"--series-2", "#2f9ed6", "#62cdef"},
    {"--series-3", "#d55e00", "#ff8d4d"},
    {"--series-4", "#00845f", "#3ccb9f"},
    {"--series-5", "#b54a8f", "#e892c8"},
    {"--series-6", "#9a7209", "#dfb44a"},
    {"--series-7", "#6b6b6b", "#a5a5a5"},
}};

inline constexpr std::string_view ink = colour_roles[0].light;
inline constexpr std::string_view soft_ink = colour_roles[1].light;
inline constexpr std::string_view rule_colour = colour_roles[2].light;

/// Colour and gnuplot point type of the i-th series; the seven repeat.
constexpr std::string_view series_colour(std::size_t i) {
    return colour_roles[3 + i % 7].light;
}
constexpr int series_point(std::size_t i) {
    constexpr std::array<int, 7> points{7, 6, 5, 9, 13, 4, 8};
    return points[i % points.size()];
}

/// "#a0rrggbb": gnuplot's way to say that a colour lets `transparency` in [0, 1] of the ground
/// through.
std::string faint(std::string_view colour, double transparency);

/// The commands every figure begins with: thin axes left and below, ticks outside, no frame.
std::string axes_style();

inline constexpr std::string_view figure_font = "Helvetica";
inline constexpr double figure_font_px = 12.0;

/// "font 'Helvetica:Bold,13'" for a text of this height.
std::string font_clause(double size_px, bool bold = false);

}  // namespace specula
