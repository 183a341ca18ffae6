#pragma once

#include <filesystem>
#include <vector>

#include "tools/report/report_page.hpp"
#include "tools/report/study_figures.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

/// One drawn figure of the study.
struct DrawnStudyFigure {
    ReportFigure figure;
    FigurePlace place = FigurePlace::paper;
};

/// The page of the study: table, figures, what agrees and why, provenance.
ReportPage study_page(const StudySummary& study, const std::vector<DrawnStudyFigure>& figures);

/// Draws all figures into FOLDER/figures (SVG, PNG, CSV), writes FOLDER/report.html, and returns
/// its path. The same summary gives the same bytes.
std::filesystem::path write_study_report(const std::filesystem::path& folder,
                                         const StudySummary& study);

}  // namespace specula
