#include "sim/core/document.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

const std::vector<std::string> materials{"aluminium", "iron", "limestone", "plexiglass", "wood"};

TEST_CASE("a word with a typing mistake finds what was meant", "[nearest word]") {
    CHECK(nearest_word("iron", materials) == "iron");
    CHECK(nearest_word("plexiglas", materials) == "plexiglass");    // one missing
    CHECK(nearest_word("plexiiglass", materials) == "plexiglass");  // one too many
    CHECK(nearest_word("wodo", materials) == "wood");               // two in the wrong order
    CHECK(nearest_word("aluminum", materials) == "aluminium");
    CHECK(nearest_word("Limestone", materials) == "limestone");
    CHECK(nearest_word("heigth_mm", {"height_mm", "weight_kg"}) == "height_mm");
}

TEST_CASE("a word unlike all others finds nothing", "[nearest word]") {
    CHECK(nearest_word("concrete", materials).empty());
    CHECK(nearest_word("", materials).empty());
    CHECK(nearest_word("anything", {}).empty());
}

TEST_CASE("a short word is not taken for another that shares none of its letters",
          "[nearest word]") {
    CHECK(nearest_word("q", {"a", "b", "c", "d"}).empty());
    CHECK(nearest_word("ry", {"tx", "rx"}) == "rx");  // one edit of two
    CHECK(nearest_word("xy", {"ab", "cd"}).empty());
    CHECK(nearest_word("air", {"iron", "wood"}).empty());
}

TEST_CASE("a swap of neighbours is one edit, so it beats two replacements", "[nearest word]") {
    CHECK(nearest_word("abdc", {"abxy", "abcd"}) == "abcd");
    CHECK(nearest_word("abdc", {"abcd", "abxy"}) == "abcd");
}

TEST_CASE("of words equally near the first is taken", "[nearest word]") {
    CHECK(nearest_word("height_xm", {"height_cm", "height_mm"}) == "height_cm");
}

TEST_CASE("a long word may differ in a third of its letters", "[nearest word]") {
    CHECK(nearest_word("abcdefghijkl", {"abcdefghWXYZ"}) == "abcdefghWXYZ");
    CHECK(nearest_word("abcdefghijkl", {"abcdefgVWXYZ"}).empty());
}

TEST_CASE("words that are not ASCII are compared byte by byte", "[nearest word]") {
    CHECK(nearest_word("h\xc3\xb6he_mm", {"height_mm", "hohe_mm"}) == "hohe_mm");
}

TEST_CASE("a list is quoted, and its last two joined by or", "[nearest word]") {
    CHECK(quoted_list({}).empty());
    CHECK(quoted_list({"a"}) == "\"a\"");
    CHECK(quoted_list({"a", "b"}) == "\"a\" or \"b\"");
    CHECK(quoted_list({"a", "b", "c"}) == "\"a\", \"b\" or \"c\"");
}

}  // namespace
}  // namespace specula
