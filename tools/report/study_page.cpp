#include "tools/report/study_page.hpp"

#include <algorithm>

#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "tools/report/html_report.hpp"
#include "tools/report/number_text.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/report/result_tables.hpp"
#include "tools/report/study_findings.hpp"
#include "tools/report/study_numbers.hpp"
#include "tools/report/study_tables.hpp"

namespace specula {
namespace {

std::size_t n_worlds(const StudySummary& study) {
    std::size_t n = 0;
    for (const StudyCondition& condition : study.conditions)
        n = std::max(n, condition.result.macro_f1_per_world.size());
    return n;
}

/// "94.6 % under the nominal geometry (the paper: 94.2 %), ..."
std::string summary(const StudySummary& study) {
    std::vector<std::string> items;
    for (const StudyCondition& condition : study.conditions) {
        const auto& paper = condition.paper_macro_f1;
        items.push_back(format("{} {}{}", percent_text(condition.result.macro_f1.mean),
                               where(condition),
                               paper ? format(" (the paper: {})", percent_text(*paper)) : ""));
    }
    return format("Over {} simulated {} the mean macro-F1 is {}.", n_worlds(study),
                  n_worlds(study) == 1 ? "world" : "worlds", listed(items));
}

/// What the descriptor is, as far as the summary says.
Paragraph radar_facts(const StudySummary& study) {
    const RadarFacts& radar = study.radar;
    std::string text;
    if (radar.slope_hz_s > 0.0)
        text += format(
            "The chirp of the {} begins at {}\u00a0GHz and rises by {}\u00a0MHz per "
            "microsecond; {}\u00a0GHz of it are sampled. ",
            radar.name.empty() ? "radar" : radar.name,
            fixed_text(radar.start_frequency_hz * 1e-9, 2), fixed_text(radar.slope_hz_s * 1e-12, 1),
            fixed_text(radar.sampled_bandwidth_hz * 1e-9, 2));
    if (radar.range_bin_m > 0.0)
        text += format(
            "Range bins are {}\u00a0cm apart; the echo of the nominal height, {}\u00a0cm, "
            "lies at bin {}. ",
            fixed_text(100.0 * radar.range_bin_m, 2), fixed_text(100.0 * radar.nominal_height_m, 1),
            fixed_text(radar.nominal_height_bin, 1));
    if (!text.empty()) text.pop_back();
    return {.lead = {}, .text = text};
}

/// What the results rest on that is not known to hold.
std::vector<Paragraph> known_limits(const StudySummary& study) {
    std::vector<Paragraph> paragraphs{{.lead = {},
                                       .text = "Here numbers are used outside the band that their "
                                               "sources give for them, or the theory "
                                               "at the edge of what full-wave solutions confirm."}};
    for (const std::string& warning : study.warnings)
        paragraphs.push_back({.lead = {}, .text = warning});
    return paragraphs;
}

std::vector<ReportFigure> figures_at(const std::vector<DrawnStudyFigure>& figures,
                                     FigurePlace place) {
    std::vector<ReportFigure> chosen;
    for (const DrawnStudyFigure& drawn : figures)
        if (drawn.place == place) chosen.push_back(drawn.figure);
    return chosen;
}

std::vector<std::pair<std::string, std::string>> provenance(const StudySummary& study) {
    std::vector<std::pair<std::string, std::string>> entries{
        {"Program", "specula " + study.version},   {"Command", study.command},
        {"Experiment", study.experiment},          {"Seed", format("{}", study.seed)},
        {"Worlds", format("{}", n_worlds(study))}, {"Paper", study.paper_reference}};
    entries.insert(entries.end(), study.fingerprints.begin(), study.fingerprints.end());
    std::erase_if(entries, [](const auto& entry) { return entry.second.empty(); });
    return entries;
}

/// Sections of what a study found beyond its conditions.
void add_results(const StudySummary& study, const std::vector<DrawnStudyFigure>& figures,
                 ReportPage& page) {
    page.sections.push_back({"Where the loss comes from",
                             {},
                             attribution_tables(study),
                             figures_at(figures, FigurePlace::attribution)});
    page.sections.push_back({"Remedies, one by one",
                             {},
                             remedy_tables(study),
                             figures_at(figures, FigurePlace::remedies)});
    page.sections.push_back({"How severe a shift may be",
                             {},
                             severity_tables(study),
                             figures_at(figures, FigurePlace::severity)});
    page.sections.push_back({"What could warn of a shift",
                             {},
                             confidence_tables(study),
                             figures_at(figures, FigurePlace::monitors)});
    page.sections.push_back({"Whether this can be believed",
                             {},
                             check_tables(study),
                             figures_at(figures, FigurePlace::checks)});
}

FigureWidth width_at(FigurePlace place) {
    switch (place) {
        case FigurePlace::overview:
            return FigureWidth::column;
        case FigurePlace::paper:
            return FigureWidth::half;
        default:
            return FigureWidth::full;
    }
}

DrawnStudyFigure drawn(const std::filesystem::path& folder, const StudyFigure& study_figure) {
    const Figure& figure = study_figure.figure;
    return {.figure = {.name = figure.name,
                       .caption = study_figure.caption,
                       .svg = write_figure(folder, figure).svg,
                       .csv = figure.csv,
                       .width = width_at(study_figure.place)},
            .place = study_figure.place};
}

}  // namespace

ReportPage study_page(const StudySummary& study, const std::vector<DrawnStudyFigure>& figures) {
    const Paragraph radar = radar_facts(study);
    ReportPage page{.title = study.title,
                    .subtitle = study.paper_reference.empty()
                                    ? ""
                                    : "Simulated with Specula, beside " + study.paper_reference,
                    .summary = summary(study),
                    .sections = {},
                    .provenance = provenance(study)};
    std::vector<ReportTable> scores{macro_f1_table(study)};
    for (ReportTable& table : part_tables(study)) scores.push_back(std::move(table));
    page.sections = {
        {"In plain words", plain_words(study), {}, {}},
        {"Macro-F1 under each condition",
         {calibration_words(study.results.calibration)},
         scores,
         figures_at(figures, FigurePlace::overview)},
        {"What agrees, what does not, and why", study_findings(study), {}, {}},
        {"The paper\u2019s figures, simulated", {}, {}, figures_at(figures, FigurePlace::paper)},
        {"How the inputs drift",
         radar.text.empty() ? std::vector<Paragraph>{} : std::vector{radar},
         {monitor_table(study)},
         figures_at(figures, FigurePlace::drift)}};
    add_results(study, figures, page);
    std::erase_if(page.sections, [](const ReportSection& section) {
        return section.paragraphs.empty() && section.tables.empty() && section.figures.empty();
    });
    if (!study.warnings.empty())
        page.sections.push_back({"Beyond what is known", known_limits(study), {}, {}});
    return page;
}

std::filesystem::path write_study_report(const std::filesystem::path& folder,
                                         const StudySummary& study) {
    SPECULA_EXPECT(!study.conditions.empty());
    std::vector<DrawnStudyFigure> figures;
    for (const StudyFigure& figure : study_figures(study))
        figures.push_back(drawn(folder / "figures", figure));
    const std::filesystem::path path = folder / "report.html";
    write_html_report(path, study_page(study, figures));
    return path;
}

}  // namespace specula
