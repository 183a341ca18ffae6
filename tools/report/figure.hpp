#pragma once

#include <string>

namespace specula {

/// One plot, before it is drawn: what gnuplot shall do, and the numbers it shows.
struct Figure {
    std::string name;         ///< file stem: lower-case letters, digits, '_'
    std::string title;        ///< one line, for people
    std::string description;  ///< what a reader who cannot see the plot should know
    std::string script;       ///< gnuplot commands; sets neither terminal nor output
    std::string csv;          ///< the plotted data, so that anyone can replot
    double width_in = 5.0;
    double height_in = 4.0;
};

}  // namespace specula
