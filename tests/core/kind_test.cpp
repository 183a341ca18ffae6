#include "sim/core/kind.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

struct Circle {
    static constexpr std::string_view kind = "circle";
    double radius_m = 0.0;
    static Circle read(Section& section) {
        return {section.quantity("radius", Unit::length, Range::above(0.0))};
    }
};
struct Square {
    static constexpr std::string_view kind = "square";
    double side_m = 0.0;
    static Square read(Section& section) {
        return {section.quantity("side", Unit::length, Range::above(0.0))};
    }
};
using Shape = std::variant<Circle, Square>;

Shape read_shape(const std::string& text) {
    Section section = Section::parse(text, "x.toml");
    Shape shape = read_kind<Shape>(section, "shape");
    section.finish();
    return shape;
}

TEST_CASE("a family names its members in the order of its variant", "[kind]") {
    CHECK(kinds_of<Shape>() == std::vector<std::string>{"circle", "square"});
}

TEST_CASE("the named member of a family reads its own keys", "[kind]") {
    CHECK(std::get<Circle>(read_shape("shape = 'circle'\nradius_mm = 20")).radius_m == 0.02);
    CHECK(std::get<Square>(read_shape("shape = 'square'\nside_mm = 30")).side_m == 0.03);
}

TEST_CASE("keys of another member of the family are refused", "[kind]") {
    CHECK(message_of([] { return read_shape("shape = 'square'\nside_mm = 30\nradius_mm = 20"); }) ==
          "x.toml:3: radius_mm = 20: is not a key of this file; remove it");
    CHECK(message_of([] { return read_shape("shape = 'circle'\nside_mm = 30"); }) ==
          "x.toml:1: radius_mm: is missing; add it");
}

TEST_CASE("a member that a family lacks is refused with the nearest and with all", "[kind]") {
    CHECK(message_of([] { return read_shape("shape = 'cirle'"); }) ==
          "x.toml:1: shape = \"cirle\": is not known; did you mean \"circle\"? "
          "use \"circle\" or \"square\"");
    CHECK(message_of([] { return read_shape("shape = 'Hexagon'"); }) ==
          "x.toml:1: shape = \"Hexagon\": is not known; use \"circle\" or \"square\"");
}

}  // namespace
}  // namespace specula
