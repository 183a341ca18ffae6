#pragma once

#include <string>
#include <string_view>

#include "tools/report/figure.hpp"

namespace specula {

/// gnuplot's SVG, made fit to publish: the figure's own title and description in place of
/// gnuplot's, no two elements with one id, a font family with substitutes, no empty groups.
std::string titled_svg(std::string_view drawn, const Figure& figure);

/// What `titled_svg` gave, made part of an HTML page: ids begin with `prefix`, the white ground is
/// gone, and colours that have a role (figure_style.hpp) follow the page, black as `currentColor`.
/// Other colours, such as those of a heat map and of the numbers on it, stay.
std::string inline_svg(std::string_view svg, const std::string& prefix);

}  // namespace specula
