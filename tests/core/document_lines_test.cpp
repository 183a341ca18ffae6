#include "sim/core/document.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

using Lines = std::vector<std::string>;

TEST_CASE("the lines of a file hold every value with its whole key", "[document]") {
    CHECK(Section::parse("b = 0.1\na = \"x\"\n[s]\nlist = [1, 2.5]\nlaw = { uniform = [3, 4] }\n"
                         "[[t]]\nyes = true\n[[t]]\nyes = false\n",
                         "a.toml")
              .value_lines() == Lines{"a = \"x\"", "b = 0.1", "s.law.uniform[0] = 3",
                                      "s.law.uniform[1] = 4", "s.list[0] = 1", "s.list[1] = 2.5",
                                      "t[0].yes = true", "t[1].yes = false"});
}

TEST_CASE("comments, order and spaces make no other lines, a value does", "[document]") {
    const Lines lines = Section::parse("a = 1\nb = 2\n", "a.toml").value_lines();
    CHECK(Section::parse("# why\nb =   2\n\na = 1 # so\n", "b.toml").value_lines() == lines);
    CHECK(Section::parse("a = 1\nb = 2.5\n", "a.toml").value_lines() != lines);
}

TEST_CASE("a text of several lines stays on one", "[document]") {
    CHECK(Section::parse("a = \"x\\ny = 3\"\n", "a.toml").value_lines() ==
          Lines{"a = \"x y = 3\""});
}

}  // namespace
}  // namespace specula
