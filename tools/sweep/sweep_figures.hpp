#pragma once

#include <vector>

#include "tools/report/figure.hpp"
#include "tools/sweep/sweep.hpp"

namespace specula {

/// What can be drawn of a sweep, and what would not fit.
struct SweepFigures {
    /// level_over_tilt, _height and _frequency, for each of these axes with more than one value;
    /// where none has, level_over_size.
    std::vector<Figure> figures;
    std::vector<std::string> remarks;  ///< of curves and panels left out; the table has them all
};

/// A curve for each specimen, or for each size where there is one specimen only; a panel for each
/// combination of the axes that are left.
SweepFigures sweep_figures(const Sweep& sweep);

}  // namespace specula
