#pragma once

#include <string>
#include <utility>
#include <vector>

namespace specula {

/// A run of text. `lead` opens it in bold, as journals set run-in headings; it may be empty.
struct Paragraph {
    std::string lead;
    std::string text;
};

struct ReportColumn {
    std::string group;  ///< neighbours of one group share a heading; may be empty
    std::string heading;
    bool is_number = true;  ///< numbers are set flush right
};

/// The first cell of each row names the row.
struct ReportTable {
    std::string caption;
    std::vector<ReportColumn> columns;
    std::vector<std::vector<std::string>> rows;  ///< (row, column)
    std::string note;                            ///< below the table; may be empty
};

/// How a figure sits on the page. Each scales down to the screen of a phone, except `full`, which
/// then scrolls sideways.
enum class FigureWidth {
    half,    ///< two beside each other
    column,  ///< alone, in its own size
    full,    ///< alone, as wide as the page
};

struct ReportFigure {
    std::string name;  ///< unique on the page; names the data file that the caption offers
    std::string caption;
    std::string svg;  ///< as `render_figure` gives it
    std::string csv;  ///< the plotted data; empty: none offered
    FigureWidth width = FigureWidth::half;
};

struct ReportSection {
    std::string heading;
    std::vector<Paragraph> paragraphs;
    std::vector<ReportTable> tables;
    std::vector<ReportFigure> figures;
};

/// All texts are plain: the page escapes them. Figures and tables are numbered in order.
struct ReportPage {
    std::string title;
    std::string subtitle;  ///< may be empty
    std::string summary;   ///< one paragraph
    std::vector<ReportSection> sections;
    std::vector<std::pair<std::string, std::string>> provenance;  ///< what, value
};

}  // namespace specula
