#include "tools/report/html_report.hpp"

#include "sim/core/atomic_file.hpp"
#include "sim/core/format.hpp"
#include "tools/report/html_parts.hpp"
#include "tools/report/markup.hpp"

namespace specula {
namespace {

struct Numbering {
    int table = 0, figure = 0;
};

std::string head(const std::string& title) {
    return format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>{}</title>\n<style>\n{}</style>\n</head>\n",
        escaped(title), html_style());
}

std::string paragraph(const Paragraph& paragraph) {
    const std::string lead =
        paragraph.lead.empty() ? "" : format("<b class=\"lead\">{}</b> ", escaped(paragraph.lead));
    return format("<p>{}{}</p>\n", lead, escaped(paragraph.text));
}

std::string section(const ReportSection& content, Numbering& numbering) {
    std::string html = format("<section>\n<h2>{}</h2>\n", escaped(content.heading));
    for (const Paragraph& text : content.paragraphs) html += paragraph(text);
    for (const ReportTable& table : content.tables) html += html_table(table, ++numbering.table);
    if (!content.figures.empty()) html += "<div class=\"figures\">\n";
    for (const ReportFigure& figure : content.figures)
        html += html_figure(figure, ++numbering.figure);
    if (!content.figures.empty()) html += "</div>\n";
    return html + "</section>\n";
}

std::string provenance(const ReportPage& page) {
    if (page.provenance.empty()) return {};
    std::string html = "<footer>\n<h2>Provenance</h2>\n<dl>\n";
    for (const auto& [what, value] : page.provenance)
        html += format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(value));
    return html + "</dl>\n</footer>\n";
}

}  // namespace

std::string html_report(const ReportPage& page) {
    Numbering numbering;
    std::string html =
        head(page.title) + format("<body>\n<main>\n<header>\n<h1>{}</h1>\n", escaped(page.title));
    if (!page.subtitle.empty())
        html += format("<p class=\"subtitle\">{}</p>\n", escaped(page.subtitle));
    html += format("<p class=\"summary\">{}</p>\n</header>\n", escaped(page.summary));
    for (const ReportSection& content : page.sections) html += section(content, numbering);
    return html + provenance(page) + "</main>\n</body>\n</html>\n";
}

void write_html_report(const std::filesystem::path& path, const ReportPage& page) {
    write_file_atomically(path, html_report(page));
}

}  // namespace specula
