#include "sim/core/format.hpp"
#include "tools/report/html_parts.hpp"
#include "tools/report/markup.hpp"
#include "tools/report/svg.hpp"

namespace specula {
namespace {

const char* class_of(FigureWidth width) {
    switch (width) {
        case FigureWidth::half:
            break;
        case FigureWidth::column:
            return " class=\"column\"";
        case FigureWidth::full:
            return " class=\"full\"";
    }
    return "";
}

/// The data travel inside the page, so that it may be mailed alone and still be replotted.
std::string data_link(const ReportFigure& figure) {
    if (figure.csv.empty()) return {};
    return format(
        " <a class=\"data\" download=\"{}.csv\" href=\"data:text/csv;charset=utf-8,{}\">"
        "Data\u00a0(CSV)</a>",
        escaped(figure.name), percent_encoded(figure.csv));
}

}  // namespace

std::string html_figure(const ReportFigure& figure, int number) {
    return format(
        "<figure{0} id=\"figure-{1}\">\n<div class=\"drawing\">{2}</div>\n"
        "<figcaption><b>Figure {1}:</b> {3}{4}</figcaption>\n</figure>\n",
        class_of(figure.width), number, inline_svg(figure.svg, format("f{}", number)),
        escaped(figure.caption), data_link(figure));
}

}  // namespace specula
