#pragma once

#include <filesystem>
#include <string>

#include "tools/report/figure.hpp"

namespace specula {

/// A figure as drawn.
struct Drawing {
    std::string svg;  ///< black on white, stands alone
    std::string png;  ///< the same at 192 pixels per inch
};

/// Draws with gnuplot. The same figure gives the same bytes. Throws SystemError, naming the figure.
Drawing render_figure(const Figure& figure);

/// Writes NAME.svg, NAME.png and NAME.csv, each of them whole or not at all.
void write_figure(const std::filesystem::path& folder, const Figure& figure,
                  const Drawing& drawing);

/// Draws and writes.
Drawing write_figure(const std::filesystem::path& folder, const Figure& figure);

}  // namespace specula
