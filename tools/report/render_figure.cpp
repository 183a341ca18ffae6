#include "tools/report/render_figure.hpp"

#include <cmath>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/figure_style.hpp"
#include "tools/report/gnuplot.hpp"
#include "tools/report/svg.hpp"

namespace specula {
namespace {

constexpr double svg_px_per_in = 96.0;  // what CSS calls an inch

std::string svg_terminal(const Figure& figure) {
    return format(
        "set terminal svg size {:.0f},{:.0f} fixed noenhanced font '{},{}' background rgb "
        "'white'\n",
        figure.width_in * svg_px_per_in, figure.height_in * svg_px_per_in, figure_font,
        figure_font_px);
}

/// Twice the pixels of the SVG, and the same look: pngcairo counts a font's points as 1/72 in.
std::string png_terminal(const Figure& figure) {
    constexpr double zoom = 2.0;
    return format(
        "set terminal pngcairo size {:.0f},{:.0f} noenhanced font '{},{}' fontscale {} "
        "linewidth {} pointscale {} background rgb 'white'\n",
        figure.width_in * svg_px_per_in * zoom, figure.height_in * svg_px_per_in * zoom,
        figure_font, figure_font_px, zoom * 72.0 / svg_px_per_in, zoom, zoom * 1.35);
}

}  // namespace

Drawing render_figure(const Figure& figure) {
    SPECULA_EXPECT(!figure.name.empty() && figure.width_in > 0.0 && figure.height_in > 0.0);
    try {
        return {.svg = titled_svg(run_gnuplot(svg_terminal(figure) + figure.script), figure),
                .png = run_gnuplot(png_terminal(figure) + figure.script)};
    } catch (const SystemError& error) {
        throw SystemError(format("figure {}: {}", figure.name, error.what()));
    }
}

void write_figure(const std::filesystem::path& folder, const Figure& figure,
                  const Drawing& drawing) {
    write_file_atomically(folder / (figure.name + ".svg"), drawing.svg);
    write_file_atomically(folder / (figure.name + ".png"), drawing.png);
    write_file_atomically(folder / (figure.name + ".csv"), figure.csv);
}

Drawing write_figure(const std::filesystem::path& folder, const Figure& figure) {
    Drawing drawing = render_figure(figure);
    write_figure(folder, figure, drawing);
    return drawing;
}

}  // namespace specula
