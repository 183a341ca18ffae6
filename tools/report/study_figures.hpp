#pragma once

#include <string>
#include <vector>

#include "tools/report/figure.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

/// Where on the page a figure belongs.
enum class FigurePlace {
    overview,
    paper,
    drift,
    attribution,
    remedies,
    severity,
    checks,
    monitors
};

struct StudyFigure {
    Figure figure;
    std::string caption;
    FigurePlace place = FigurePlace::paper;
};

/// All figures of the study, in the order of the page: macro-F1 of every condition, then the
/// paper's figures under the paper's own names and in its order, then what the paper does not show.
/// Figures of conditions that the study lacks are left out.
std::vector<StudyFigure> study_figures(const StudySummary& study);

}  // namespace specula
