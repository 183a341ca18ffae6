#include "sim/core/document.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/section_of.hpp"

// Keys, types, tables and what is said about them. Numbers with a unit: document_quantity_test.cpp;
// files: document_file_test.cpp.

namespace specula {
namespace {

constexpr const char* every_type =
    "text = 'word'\n"     // 1
    "whole = 3\n"         // 2
    "real = 2.5\n"        // 3
    "truth = true\n"      // 4
    "list = [1, 2]\n"     // 5
    "[table]\n"           // 6
    "inner = 1\n"         // 7
    "[[tables]]\n"        // 8
    "name = 'first'\n"    // 9
    "[[tables]]\n"        // 10
    "name = 'second'\n";  // 11

TEST_CASE("values come back as they were written", "[document]") {
    Section section = section_of(every_type);
    CHECK(section.text("text") == "word");
    CHECK(section.count("whole", Range::any()) == 3);
    CHECK(section.number("whole", Range::any()) == 3.0);
    CHECK(section.number("real", Range::any()) == 2.5);
    CHECK(section.flag("truth", false));
    CHECK(section.numbers("list", 2, Range::any()) == std::vector<double>{1.0, 2.0});
    CHECK(section.section("table").count("inner", Range::any()) == 1);
    std::vector<std::string> names;
    for (Section& table : section.sections("tables")) names.push_back(table.text("name"));
    CHECK(names == std::vector<std::string>{"first", "second"});
    CHECK_NOTHROW(section.finish());
    CHECK(section.file() == "x.toml");
    CHECK(section.source() == every_type);
}

TEST_CASE("a text is one line, in a list and as a choice too", "[document]") {
    Section section =
        section_of("text = \"bo\\nard\"\nlist = [\"a\", \"\\u001b[31m\"]\nbell = \"\\u007f\"");
    const std::string problem =
        ": holds a line break or another control character; write one line of text";
    CHECK(message_of([&] { return section.text("text"); }).ends_with(problem));
    CHECK(message_of([&] { return section.texts("list"); }).ends_with(problem));
    CHECK(message_of([&] { return section.choice("bell", {"a"}); }).ends_with(problem));
}

TEST_CASE("a fallback stands in for a missing key only", "[document]") {
    Section section = section_of("text = ''\nwhole = 1.5\nreal = 'x'\ntruth = 1\nlaw = 'x'");
    CHECK(section.text("none", "fallback") == "fallback");
    CHECK(section.choice("none", {"a", "b"}, "b") == "b");
    CHECK(section.count("none", Range::any(), 7) == 7);
    CHECK(section.number("none", Range::any(), 7.5) == 7.5);
    CHECK(section.flag("none", true));
    CHECK_FALSE(section.has("none"));
    CHECK_FALSE(section.find_section("none"));
    CHECK(section.sections("none").empty());
    CHECK_THROWS_AS(section.text("text", "fallback"), InputError);
    CHECK_THROWS_AS(section.choice("text", {"a"}, "a"), InputError);
    CHECK_THROWS_AS(section.count("whole", Range::any(), 7), InputError);
    CHECK_THROWS_AS(section.number("real", Range::any(), 7.5), InputError);
    CHECK_THROWS_AS(section.flag("truth", true), InputError);
    CHECK_THROWS_AS(section.factor("law", Range::any(), 1.0), InputError);
    CHECK_THROWS_AS(section.find_section("text"), InputError);
}

TEST_CASE("a value of another type is refused with its line and what to write", "[document]") {
    Section section = section_of(every_type);
    const auto any = Range::any();
    CHECK(message_of([&] { return section.text("whole"); }) ==
          "x.toml:2: whole = 3: is not text; put it in quotes");
    CHECK(message_of([&] { return section.number("text", Range::at_least(1.0)); }) ==
          "x.toml:1: text = \"word\": is not a number; give a number at least 1");
    CHECK(message_of([&] { return section.number("truth", any); }) ==
          "x.toml:4: truth = true: is not a number; give a number that is finite");
    CHECK(message_of([&] { return section.count("real", Range::between(1, 9)); }) ==
          "x.toml:3: real = 2.5: is not a whole number; "
          "give a whole number at least 1 and at most 9");
    CHECK(message_of([&] { return section.flag("whole", true); }) ==
          "x.toml:2: whole = 3: is not true or false; write true or false, no quotes");
    CHECK(message_of([&] { return section.numbers("real", 0, any); }) ==
          "x.toml:3: real = 2.5: is not a list of the right length; give a list: [...]");
    CHECK(message_of([&] { return section.texts("text"); }) ==
          "x.toml:1: text = \"word\": is not a list; write [\"a\", \"b\"]");
    CHECK(message_of([&] { return section.texts("list"); }) ==
          "x.toml:5: list = [1, 2]: holds something that is not text; put it in quotes");
    CHECK(message_of([&] { return section.section("tables"); }) ==
          "x.toml:8: tables = [{...}, {...}]: is not a table; write [tables]");
    CHECK(message_of([&] { return section.sections("table"); }) ==
          "x.toml:6: table = {...}: is not a list of tables; write [[table]]");
    CHECK(message_of([&] { return section.sections("list"); }) ==
          "x.toml:5: list = [1, 2]: is not a list of tables; write [[list]]");
    CHECK(message_of([] { return section_of("t = 2020-01-01").text("t"); }) ==
          "x.toml:1: t = (a date or time): is not text; put it in quotes");
    CHECK(message_of([] { return section_of("t = ''").text("t"); }) ==
          "x.toml:1: t = \"\": is empty; give a word");
}

TEST_CASE("arrays are refused by length and by what they hold", "[document]") {
    const auto numbers = [](const std::string& text, std::size_t size) {
        return message_of([&] { return section_of(text).numbers("v", size, Range::above(0.0)); });
    };
    CHECK(numbers("v = [1, 2.5]", 2) == "(no error)");
    CHECK(numbers("v = [1, 2, 3]", 0) == "(no error)");
    CHECK(numbers("v = [1, 2, 3]", 2) ==
          "x.toml:1: v = [1, 2, 3]: is not a list of the right length; give 2 numbers: [...]");
    CHECK(numbers("v = []", 0) ==
          "x.toml:1: v = []: is not a list of the right length; give a list: [...]");
    CHECK(numbers("v = [1, 'b']", 2) ==
          "x.toml:1: v = [1, \"b\"]: is not a number; give a number above 0");
    CHECK(numbers("v = [1, 0]", 2) ==
          "x.toml:1: v = [1, 0]: is out of range; give a value above 0");
    CHECK(message_of([] { return section_of("v = []").texts("v"); }) ==
          "x.toml:1: v = []: is empty; write [\"a\", \"b\"]");
    CHECK(message_of([] { return section_of("v = []").sections("v"); }) ==
          "x.toml:1: v = []: is not a list of tables; write [[v]]");
}

TEST_CASE("a count is refused where it would not fit into an int", "[document]") {
    CHECK(section_of("n = 2147483647").count("n", Range::at_least(0)) == 2147483647);
    CHECK(message_of([] { return section_of("n = 2147483648").count("n", Range::at_least(0)); }) ==
          "x.toml:1: n = 2147483648: is out of range; "
          "give a value at least 0 and at most 2147483647");
    CHECK_THROWS_AS(section_of("n = -9223372036854775808").count("n", Range::any()), InputError);
}

TEST_CASE("a missing key is named with the line of its table", "[document]") {
    Section section = section_of("[sample]\nsize_mm = 3\n\n[[rx]]\n\n[[rx]]\ngain_db = 1");
    CHECK(message_of([&] { return section.text("radar"); }) ==
          "x.toml:1: radar: is missing; add it");
    CHECK(message_of([&] { return section.section("sample").text("material"); }) ==
          "x.toml:1: sample.material: is missing; add it");
    CHECK(message_of([&] { return section.sections("rx")[1].flag("inverted", true); }) ==
          "(no error)");
    CHECK(message_of([&] { return section.sections("rx")[1].text("name"); }) ==
          "x.toml:6: rx.name: is missing; add it");
}

TEST_CASE("a missing key that was misspelt is pointed at", "[document]") {
    CHECK(message_of([] { return section_of("a = 1\nmateriel = 'wood'").text("material"); }) ==
          "x.toml:1: material: is missing; add it, or is it meant by materiel in line 2?");
    CHECK(message_of([] { return section_of("\n[geometrie]\nx = 1").section("geometry"); }) ==
          "x.toml:1: geometry: is missing; add it, or is it meant by geometrie in line 2?");
    // A key with a meaning of its own is not taken for a misspelt one.
    CHECK(message_of([] {
              Section section = section_of("titel2 = 1");
              (void)section.number("titel2", Range::any());
              return section.text("title");
          }) == "x.toml:1: title: is missing; add it");
}

TEST_CASE("a key nobody asked for is refused with its line and the nearest known one",
          "[document]") {
    const auto finish = [](const std::string& text) {
        return message_of([&] {
            Section section = section_of(text);
            (void)section.text("title", "");
            (void)section.number("gain", Range::any(), 0.0);
            section.finish();
            return 0;
        });
    };
    CHECK(finish("title = 'a'\ngain = 1") == "(no error)");
    CHECK(finish("gain = 1\ntilte = 'a'") ==
          "x.toml:2: tilte = \"a\": is not a key of this file; did you mean title?");
    CHECK(finish("gain = 1\nweight = [1]") ==
          "x.toml:2: weight = [1]: is not a key of this file; remove it");
    CHECK(finish("[gian]\nx = 1") ==
          "x.toml:1: gian = {...}: is not a key of this file; did you mean gain?");
    CHECK(finish("zz = 1\naa = 2") == "x.toml:1: zz = 1: is not a key of this file; remove it");
    CHECK(message_of([] {
              Section inner = section_of("[table]\nodd = 1").section("table");
              inner.finish();
              return 0;
          }) == "x.toml:2: table.odd = 1: is not a key of this table; remove it");
}

TEST_CASE("copies of a section remember together what was asked for", "[document]") {
    Section section = section_of("a = 1\nb = 2");
    Section copy = section;
    (void)copy.number("a", Range::any());
    (void)section.number("b", Range::any());
    CHECK_NOTHROW(section.finish());
}

TEST_CASE("a section outlives the one it was taken from", "[document]") {
    Section inner = section_of("[table]\nname = 'kept'").section("table");
    CHECK(inner.text("name") == "kept");
    CHECK(inner.source() == "[table]\nname = 'kept'");
}

TEST_CASE("keys and values that are not ASCII are quoted back whole", "[document]") {
    CHECK(message_of([] {
              section_of("\"h\xc3\xb6he_mm\" = 1").finish();
              return 0;
          }) == "x.toml:1: h\xc3\xb6he_mm = 1: is not a key of this file; remove it");
    CHECK(message_of([] { return section_of("a = '\xe9\x9b\xb7'").choice("a", {"b"}); }) ==
          "x.toml:1: a = \"\xe9\x9b\xb7\": is not known; use \"b\"");
}

TEST_CASE("whatever a key or value holds, a message is one line of readable length", "[document]") {
    CHECK(message_of([] { return section_of("a = '''x\ny'''").choice("a", {"b"}); }) ==
          "x.toml:1: a = \"x\\ny\": holds a line break or another control character; "
          "write one line of text");
    CHECK(message_of([] { return section_of("a = \"x\\ny\\u001b[2J\"").choice("a", {"b"}); }) ==
          "x.toml:1: a = \"x\\ny\\x1b[2J\": holds a line break or another control character; "
          "write one line of text");
    CHECK(message_of([] {
              section_of("\"a\\nb\" = 1").finish();
              return 0;
          }) == "x.toml:1: a\\nb = 1: is not a key of this file; remove it");
    const std::string umlauts = [] {
        std::string text;
        for (int i = 0; i < 50; ++i) text += "\xc3\xa4";
        return text;
    }();
    CHECK(message_of([&] { return section_of("a = '" + umlauts + "'").choice("a", {"b"}); }) ==
          "x.toml:1: a = \"" + umlauts.substr(0, 76) + "...: is not known; use \"b\"");
    std::string zeros = "0";
    for (int i = 0; i < 10'000; ++i) zeros += ",\n0";
    const auto long_list =
        message_of([&] { return section_of("a = [" + zeros + "]").numbers("a", 2, Range::any()); });
    CHECK(long_list.size() < 200);
}

TEST_CASE("a choice is one of its options, letter by letter", "[document]") {
    CHECK(section_of("a = 'hann'").choice("a", {"hann", "blackman"}) == "hann");
    CHECK(message_of([] {
              return section_of("\na = 'Hann'").choice("a", {"hann", "blackman"});
          }) ==
          "x.toml:2: a = \"Hann\": is not known; did you mean \"hann\"? "
          "use \"hann\" or \"blackman\"");
    // Of a long list, the nearest is enough; without one, all are told.
    std::vector<std::string> names;
    for (char c = 'a'; c <= 'm'; ++c) names.push_back(std::string(5, c));
    CHECK(message_of([&] { return section_of("a = 'aaaax'").choice("a", names); }) ==
          "x.toml:1: a = \"aaaax\": is not known; did you mean \"aaaaa\"?");
    CHECK(message_of([&] { return section_of("a = 'zzzzz'").choice("a", names); }) ==
          "x.toml:1: a = \"zzzzz\": is not known; use " + quoted_list(names));
}

TEST_CASE("who reads a key can refuse it by its place, even one that is absent", "[document]") {
    const Section section = section_of("a = 1\nlimit_cm = 2");
    CHECK(message_of([&] {
              section.fail("a", "is wrong", "change it");
              return 0;
          }) == "x.toml:1: a = 1: is wrong; change it");
    CHECK(message_of([&] {
              section.fail("b", "is wrong", "add it");
              return 0;
          }) == "x.toml:1: b: is wrong; add it");
    CHECK(message_of([&] {
              section.fail_quantity("limit", Unit::length, "is too far", "come nearer");
              return 0;
          }) == "x.toml:2: limit_cm = 2: is too far; come nearer");
    CHECK(message_of([&] {
              section.fail_quantity("depth", Unit::length, "is too deep", "come up");
              return 0;
          }) == "x.toml:1: depth_mm: is too deep; come up");
}

}  // namespace
}  // namespace specula
