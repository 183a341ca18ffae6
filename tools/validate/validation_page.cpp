#include "tools/validate/validation_page.hpp"

#include <cctype>
#include <map>

#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/validate/case_kind.hpp"
#include "tools/validate/error_figure.hpp"
#include "tools/validate/validation_table.hpp"

namespace specula {

namespace {

constexpr const char* none = "\u2013";

/// May be broken behind every underscore.
std::string breakable(const std::string& name) {
    std::string text;
    for (const char c : name) text += c == '_' ? std::string("_\u200b") : std::string(1, c);
    return text;
}

ReportTable case_table(const Validation& validation) {
    ReportTable table{.caption =
                          "Every case, and the quantity that comes nearest to its tolerance "
                          "or misses it by most.",
                      .columns = {{"", "Case", false},
                                  {"", "Verdict", false},
                                  {"", "Points"},
                                  {"", "Worst error"},
                                  {"", "Tolerance"},
                                  {"", "Quantity", false},
                                  {"", "Title", false}},
                      .rows = {},
                      .note = {}};
    for (const CaseVerdict& verdict : validation.cases) {
        const Quantity* worst = verdict.worst();
        const auto text = [&](double Quantity::*value) {
            return worst == nullptr ? none : ErrorText{worst->*value, worst->unit}.text();
        };
        table.rows.push_back({breakable(verdict.id), verdict_name(verdict.verdict()),
                              format("{}", verdict.points.size()), text(&Quantity::error),
                              text(&Quantity::tolerance),
                              worst == nullptr ? none : breakable(worst->name), verdict.title});
    }
    for (const CaseVerdict& verdict : validation.cases)
        if (const std::size_t n = verdict.n_shown_only(); n > 0)
            table.note += format("{}{}: {} numbers are informative, not judged.",
                                 table.note.empty() ? "" : " ", verdict.id, n);
    return table;
}

ReportSection complaints(const Validation& validation) {
    ReportSection section{"What does not pass, and why", {}, {}, {}};
    for (const CaseVerdict& verdict : validation.cases)
        if (const std::string problem = complaint(verdict); !problem.empty())
            section.paragraphs.push_back({verdict.id, problem});
    return section;
}

ReportSection figures(const Validation& validation) {
    std::map<std::string, std::vector<const CaseVerdict*>> groups;
    for (const CaseVerdict& verdict : validation.cases)
        groups[verdict.kind.substr(0, 1)].push_back(&verdict);
    ReportSection section{"Errors over tolerances, point by point", {}, {}, {}};
    for (const auto& [letter, cases] : groups) {
        const bool plain = !letter.empty() && std::isalnum(static_cast<unsigned char>(letter[0]));
        const std::string name =
            format("errors_{}", plain ? static_cast<char>(std::tolower(letter[0])) : 'x');
        const Figure figure = error_figure(name, case_group_title(letter), cases);
        section.figures.push_back(
            {.name = name,
             .caption = format("{}. Each dot is the quantity of a point that comes nearest to its "
                               "tolerance, the dashed line. Shares below 1e-7 are drawn there.",
                               figure.title),
             .svg = render_figure(figure).svg,
             .csv = figure.csv,
             .width = FigureWidth::full});
    }
    return section;
}

}  // namespace

ReportPage validation_page(const Validation& validation) {
    ReportPage page{.title = "Validation against reference cases",
                    .subtitle =
                        "What the program computes from the inputs of each point, beside "
                        "what the case expects",
                    .summary = validation_sum(validation) + ".",
                    .sections = {{"Cases", {}, {case_table(validation)}, {}}},
                    .provenance = {{"Program", std::string("specula ") + program_version},
                                   {"Cases", validation.folder.string()}}};
    if (ReportSection section = complaints(validation); !section.paragraphs.empty())
        page.sections.push_back(std::move(section));
    page.sections.push_back(figures(validation));
    return page;
}

}  // namespace specula
