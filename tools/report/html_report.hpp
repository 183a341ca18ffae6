#pragma once

#include <filesystem>
#include <string>

#include "tools/report/report_page.hpp"

namespace specula {

/// One HTML file that needs nothing else: no script, no network, no font files; light, dark and
/// print. Equal pages give equal bytes.
std::string html_report(const ReportPage& page);

/// Writes it whole or not at all.
void write_html_report(const std::filesystem::path& path, const ReportPage& page);

}  // namespace specula
