#include "materials/models/tabulated.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

Tabulated read(const std::string& text) {
    Section section = Section::parse(text, "x.toml");
    return Tabulated::read(section);
}

const std::string table =
    "frequency_ghz = [50, 60, 70]\npermittivity = [4.0, 3.0, 2.5]\nloss_tangent = [0, 0.1, 0.2]\n";

TEST_CASE("a table is exact at its rows and straight between them", "[tabulated]") {
    const Tabulated model = read(table);
    CHECK(model.at(50e9).permittivity == Complex(4.0, 0.0));
    CHECK(std::abs(model.at(60e9).permittivity - Complex(3.0, -0.3)) < 1e-15);
    CHECK(std::abs(model.at(70e9).permittivity - Complex(2.5, -0.5)) < 1e-15);
    CHECK(std::abs(model.at(55e9).permittivity - Complex(3.5, -0.15)) < 1e-12);
}

TEST_CASE("outside the table its nearest row holds", "[tabulated]") {
    const Tabulated model = read(table);
    CHECK(model.at(1e9).permittivity == model.at(50e9).permittivity);
    CHECK(model.at(90e9).permittivity == model.at(70e9).permittivity);
}

TEST_CASE("a table that does not rise, or whose lists differ in length, is refused",
          "[tabulated]") {
    CHECK(message_of([] { return read("frequency_ghz = [60, 60]\n"); }) ==
          "x.toml:1: frequency_ghz = [60, 60]: is not a rising list; "
          "give two frequencies at least, the lowest first");
    CHECK(message_of([] {
              return read("frequency_ghz = [50, 60]\npermittivity = [2.0]\n");
          }).rfind("x.toml:2: permittivity = [2", 0) == 0);
}

TEST_CASE("a file may not call valid what lies outside its table", "[tabulated]") {
    CHECK(message_of([] { return read(table + "valid_ghz = [50, 80]\n"); }) ==
          "x.toml:4: valid_ghz = [50, 80]: reaches beyond the table; stay within 50 to 70 GHz");
    CHECK(read(table + "valid_ghz = [55, 65]\n").frequency_hz.size() == 3);
}

}  // namespace
}  // namespace specula
