#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/html_parts.hpp"
#include "tools/report/markup.hpp"

namespace specula {
namespace {

using Columns = std::vector<ReportColumn>;

bool has_groups(const Columns& columns) {
    for (const ReportColumn& column : columns)
        if (!column.group.empty()) return true;
    return false;
}

/// How many columns, from `first` on, share its group.
std::size_t group_width(const Columns& columns, std::size_t first) {
    std::size_t width = 1;
    while (first + width < columns.size() && !columns[first].group.empty() &&
           columns[first + width].group == columns[first].group)
        ++width;
    return width;
}

const char* side(const ReportColumn& column) {
    return column.is_number ? " class=\"number\"" : "";
}

/// Headings of groups; a column without a group spans both rows of the head.
std::string group_row(const Columns& columns) {
    std::string row = "<tr>";
    for (std::size_t i = 0; i < columns.size(); i += group_width(columns, i)) {
        if (columns[i].group.empty())
            row += format("<th scope=\"col\" rowspan=\"2\"{}>{}</th>", side(columns[i]),
                          escaped(columns[i].heading));
        else
            row +=
                format("<th scope=\"colgroup\" colspan=\"{}\" class=\"group\"><span>{}</span></th>",
                       group_width(columns, i), escaped(columns[i].group));
    }
    return row + "</tr>\n";
}

std::string heading_row(const Columns& columns, bool only_grouped) {
    std::string row = "<tr>";
    for (const ReportColumn& column : columns)
        if (!only_grouped || !column.group.empty())
            row += format("<th scope=\"col\"{}>{}</th>", side(column), escaped(column.heading));
    return row + "</tr>\n";
}

std::string body_row(const Columns& columns, const std::vector<std::string>& cells) {
    SPECULA_EXPECT(cells.size() == columns.size());
    std::string row = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
        row += i == 0 ? format("<th scope=\"row\">{}</th>", escaped(cells[i]))
                      : format("<td{}>{}</td>", side(columns[i]), escaped(cells[i]));
    return row + "</tr>\n";
}

}  // namespace

std::string html_table(const ReportTable& table, int number) {
    const bool grouped = has_groups(table.columns);
    std::string html = format(
        "<figure class=\"numbers\">\n<figcaption id=\"table-{0}\"><b>Table {0}:</b> "
        "{1}</figcaption>\n"
        "<div class=\"table\" role=\"region\" tabindex=\"0\" aria-labelledby=\"table-{0}\">\n"
        "<table aria-labelledby=\"table-{0}\">\n<thead>\n",
        number, escaped(table.caption));
    if (grouped) html += group_row(table.columns);
    html += heading_row(table.columns, grouped) + "</thead>\n<tbody>\n";
    for (const auto& row : table.rows) html += body_row(table.columns, row);
    html += "</tbody>\n</table>\n</div>\n";
    if (!table.note.empty()) html += format("<p class=\"note\">{}</p>\n", escaped(table.note));
    return html + "</figure>\n";
}

}  // namespace specula
