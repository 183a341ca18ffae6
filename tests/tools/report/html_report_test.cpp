#include "tools/report/html_report.hpp"

#include "sim/core/expect.hpp"
#include "tests/check.hpp"

using namespace specula;

namespace {

ReportPage small_page() {
    const std::string evil = "<script>alert('x')</script> & \"co\"";
    const std::string svg =
        "<svg viewBox=\"0 0 10 10\" width=\"10\" height=\"10\">\n<title>t</title>\n<desc>d</desc>\n"
        "<g id=\"a\"/></svg>\n";
    return {
        .title = evil,
        .subtitle = evil,
        .summary = evil,
        .sections = {{evil,
                      {{evil, evil}},
                      {{.caption = evil,
                        .columns = {{"", evil, false}, {evil, "mean"}, {evil, "sd"}},
                        .rows = {{evil, evil, evil}},
                        .note = evil}},
                      {{.name = evil, .caption = evil, .svg = svg, .csv = evil}}},
                     {"Second", {}, {}, {{.name = "b", .caption = "B", .svg = svg, .csv = {}}}}},
        .provenance = {{evil, evil}}};
}

}  // namespace

TEST_CASE("nothing on the page can become a script", "[report]") {
    const std::string html = html_report(small_page());
    CHECK(html.find("<script") == std::string::npos);
    CHECK(html.find("\"co\"") == std::string::npos);
    CHECK(html.find("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;co&quot;") !=
          std::string::npos);
}

TEST_CASE("the page needs nothing from outside", "[report]") {
    const std::string html = html_report(small_page());
    for (const std::string_view part : {"src=", "<link", "@import", "href=\"http", "url(http"})
        CHECK(html.find(part) == std::string::npos);
    CHECK(html.find("prefers-color-scheme:dark") != std::string::npos);
    CHECK(html.find("@media print") != std::string::npos);
}

TEST_CASE("figures and tables are numbered in order, tables have headers", "[report]") {
    const std::string html = html_report(small_page());
    for (const std::string_view part :
         {"<b>Figure 1:</b>", "<b>Figure 2:</b> B", "<b>Table 1:</b>", "<th scope=\"row\">",
          "scope=\"colgroup\" colspan=\"2\"", "id=\"f1-a\"", "id=\"f2-a\""})
        CHECK(html.find(part) != std::string::npos);
}

TEST_CASE("the same page gives the same bytes", "[report]") {
    CHECK(html_report(small_page()) == html_report(small_page()));
}

TEST_CASE("a row that does not fit its table is a mistake of ours", "[report]") {
    ReportPage page = small_page();
    page.sections[0].tables[0].rows.push_back({"short"});
    CHECK_THROWS_AS(html_report(page), BrokenPromise);
}
