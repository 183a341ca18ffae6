#pragma once

#include <string>

#include "tools/report/report_page.hpp"

namespace specula {

/// What a page is made of; `number` is the one the caption shows.

std::string html_table(const ReportTable& table, int number);
std::string html_figure(const ReportFigure& figure, int number);
std::string html_style();  ///< the style sheet

}  // namespace specula
