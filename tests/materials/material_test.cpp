#include "materials/material.hpp"

#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

using namespace literals;

constexpr const char* text =
    "title = 'Perspex'\n"                    // 1
    "source = 'made up for this test'\n"     // 2
    "valid_ghz = [40, 120]\n"                // 3
    "model = 'constant'\n"                   // 4
    "permittivity = 2.6\n"                   // 5
    "loss_tangent = 0.01\n";                 // 6

Material read(const std::string& content) {
    const MadeUpFolder folder;
    return read_material(folder.with("perspex.toml", content));
}

std::string error_with(const std::string& from, const std::string& to) {
    const MadeUpFolder folder;
    const auto file = folder.with("x.toml", edited(text, from, to));
    const std::string message = message_of([&] { return read_material(file); });
    const auto at = message.find("x.toml:");
    return at == std::string::npos ? message : message.substr(at);
}

TEST_CASE("a material is called after its file and holds in its band", "[material]") {
    const Material material = read(text);
    CHECK(material.name == "perspex");
    CHECK(material.title == "Perspex");
    CHECK(material.at(60.0_GHz).permittivity.real() == 2.6);
    CHECK(material.at(60.0_GHz).permittivity.imag() == Approx(-0.026));
    CHECK(material.valid_at(40.0_GHz));
    CHECK(material.valid_at(120.0_GHz));
    CHECK_FALSE(material.valid_at(39.9_GHz));
    CHECK_FALSE(material.valid_at(120.1_GHz));
    CHECK_FALSE(material.is_metal());
}

TEST_CASE("a material that cannot be is refused at the key to change", "[material]") {
    CHECK(error_with("[40, 120]", "[120, 40]")
              .rfind("x.toml:3: valid_ghz = [120, 40]: runs backwards; ", 0) == 0);
    CHECK(error_with("valid_ghz = [40, 120]", "valid_mhz = [5, 5]")
              .rfind("x.toml:3: valid_mhz = [5, 5]: runs backwards; ", 0) == 0);
    CHECK(error_with("[40, 120]", "60").rfind("x.toml:3: valid_ghz = 60: ", 0) == 0);
    CHECK(error_with("source = 'made up for this test'\n", "") ==
          "x.toml:1: source: is missing; add it");
    CHECK(error_with("'constant'", "'constnat'")
              .rfind("x.toml:4: model = \"constnat\": is not known; did you mean \"constant\"?", 0) ==
          0);
    CHECK(error_with("2.6", "0.9") ==
          "x.toml:5: permittivity = 0.9: is out of range; give a value at least 1");
    CHECK(error_with("0.01", "-0.01") ==
          "x.toml:6: loss_tangent = -0.01: is out of range; "
          "give a value at least 0 and at most 10");
    CHECK(error_with("loss_tangent", "los_tangent") ==
          "x.toml:1: loss_tangent: is missing; add it, or is it meant by los_tangent in line 6?");
    CHECK(error_with("model", "colour = 'clear'\nmodel") ==
          "x.toml:4: colour = \"clear\": is not a key of this file; remove it");
}

}  // namespace
}  // namespace specula
