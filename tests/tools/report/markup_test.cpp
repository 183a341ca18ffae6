#include "tools/report/markup.hpp"

#include "tests/check.hpp"
#include "tools/report/markup_walk.hpp"

using namespace specula;

TEST_CASE("text cannot become markup", "[report]") {
    CHECK(escaped("<a href=\"x\" title='y'>&amp;") ==
          "&lt;a href=&quot;x&quot; title=&#39;y&#39;&gt;&amp;amp;");
    CHECK(escaped("\u00b110\u00b0 caf\u00e9") == "\u00b110\u00b0 caf\u00e9");
}

TEST_CASE("control characters, which HTML and SVG forbid, are replaced", "[report]") {
    CHECK(escaped(std::string("a\0b\x1b", 4)) == "a\uFFFDb\uFFFD");
    CHECK(escaped("line\nbreak\ttab") == "line\nbreak\ttab");
}

TEST_CASE("data addresses hold only characters that need no quoting", "[report]") {
    CHECK(percent_encoded("a,b\n\"5 %\"") == "a%2Cb%0A%225%20%25%22");
}

TEST_CASE("attributes are found whatever their quotes, by their whole name", "[report]") {
    const std::string_view tag = "<rect data-id='no' id='box' fill=\"#fff\">";
    CHECK(attribute(tag, "id") == "box");
    CHECK(attribute(tag, "fill") == "#fff");
    CHECK(attribute(tag, "width").empty());
}
