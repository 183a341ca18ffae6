#include "tools/report/study_page.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <set>

#include "sim/core/format.hpp"
#include "tests/check.hpp"
#include "tests/tools/report/made_up_study.hpp"
#include "tools/report/html_report.hpp"
#include "tools/report/markup.hpp"

using namespace specula;

namespace {

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the report and its figures are written, and nothing else", "[report]") {
    const auto folder =
        std::filesystem::temp_directory_path() / format("specula_study_{}", ::getpid());
    StudySummary study = made_up_study();
    study.conditions.resize(1);  // drawing all figures takes more than a second
    const std::string html = content(write_study_report(folder, study));
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "figures")) {
        CHECK(entry.file_size() > 100);
        names.insert(entry.path().filename().string());
    }
    std::set<std::string> expected;
    for (const std::string_view figure :
         {"macro_f1", "confusion_baseline", "confidence_baseline", "descriptor_drift"})
        for (const std::string_view type : {"svg", "png", "csv"})
            expected.insert(format("{}.{}", figure, type));
    CHECK(names == expected);
    CHECK(html.find("<b>Figure 4:</b>") != std::string::npos);
    CHECK(html.find("<script") == std::string::npos);
    std::filesystem::remove_all(folder);
}

TEST_CASE("the page names every condition and where it all comes from", "[report]") {
    const StudySummary study = made_up_study();
    const std::string html = html_report(study_page(study, {}));
    for (const StudyCondition& condition : study.conditions)
        CHECK(html.find(escaped(condition.result.title)) != std::string::npos);
    for (const std::string_view text : {"sha256 8c1f0b7a5d", "--seed 7", "94.2", "68.5"})
        CHECK(html.find(text) != std::string::npos);
}

TEST_CASE("numbers used beyond what they are known for are told, where there are any", "[report]") {
    StudySummary study = made_up_study();
    CHECK(html_report(study_page(study, {})).find("Beyond what is known") == std::string::npos);
    study.warnings = {"brick: valid from 1 to 40 GHz, used from 58 to 62 GHz"};
    const std::string html = html_report(study_page(study, {}));
    CHECK(html.find("Beyond what is known") != std::string::npos);
    CHECK(html.find("brick: valid from 1 to 40") != std::string::npos);
}

TEST_CASE("figures of the paper come in its order, under its names", "[report]") {
    std::vector<std::string> names;
    for (const StudyFigure& figure : study_figures(made_up_study()))
        if (figure.place == FigurePlace::paper) names.push_back(figure.figure.name);
    CHECK(names == std::vector<std::string>{"confusion_baseline", "confidence_baseline",
                                            "confusion_height", "confidence_unknown",
                                            "confusion_similar", "confidence_similar",
                                            "confusion_tilt", "confidence_height"});
}

TEST_CASE("the table sets the simulated value beside the paper's", "[report]") {
    StudySummary study = made_up_study();
    study.conditions[0].result.macro_f1 = {.mean = 0.95, .low = 0.94, .high = 0.96};
    const ReportPage page = study_page(study, {});
    const std::vector<std::string>& row = page.sections.at(1).tables.front().rows.front();  // behind the plain words
    CHECK(row.at(1) == "94.2");
    CHECK(row.at(2) == "95.0");
    CHECK(row.at(3) == "94.0 to 96.0");
    CHECK(row.at(4) == "+0.8");
}

TEST_CASE("a study without descriptors or figures still makes a page", "[report]") {
    StudySummary study = made_up_study();
    for (StudyCondition& condition : study.conditions) condition.features.clear();
    study.radar = {};
    for (const StudyFigure& figure : study_figures(study))
        CHECK(figure.place != FigurePlace::drift);
    CHECK(html_report(study_page(study, {})) == html_report(study_page(study, {})));
}
