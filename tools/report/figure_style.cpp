#include "tools/report/figure_style.hpp"

#include <cmath>

#include "sim/core/format.hpp"

namespace specula {

std::string faint(std::string_view colour, double transparency) {
    return format("#{:02x}{}", static_cast<int>(std::lround(255.0 * transparency)),
                  colour.substr(1));
}

std::string axes_style() {
    return format(
        "set encoding utf8\n"
        "unset key\n"
        "set border 3 linewidth 0.8 linecolor rgb '{0}'\n"
        "set tics nomirror out scale 0.5 textcolor rgb '{0}'\n"
        "set grid back linetype 1 linewidth 0.8 linecolor rgb '{1}'\n"
        "set style fill solid noborder\n",
        soft_ink, rule_colour);
}

std::string font_clause(double size_px, bool bold) {
    return format("font '{}{},{}'", figure_font, bold ? ":Bold" : "", size_px);
}

}  // namespace specula
