#include "materials/validity.hpp"

#include "scenes/scene.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_library.hpp"

namespace specula {
namespace {

const std::string metal =
    "title = 'x'\nsource = 'y'\nvalid_ghz = [20, 300]\nmodel = 'conductive'\n"
    "conductivity_s_per_m = 1e7\npermeability = 1.5\n";

std::string number(const std::string& rest) {
    return metal + "[[number]]\nkey = 'permeability'\nsource = 'a guess'\n" + rest;
}

TEST_CASE("within its band a material has no warnings, at the edge neither", "[validity]") {
    CHECK(band_warnings(*library().find("marble"), {1e9, 60e9}).empty());
    CHECK(band_warnings(*library().find("plexiglass"), {57e9, 64e9}).empty());
}

TEST_CASE("a warning names the material, where it holds and where it is used", "[validity]") {
    const auto warnings = band_warnings(*library().find("marble"), {57.5e9, 61.3e9});
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].number.empty());
    CHECK(warnings[0].valid.max_hz == 60e9);
    CHECK(warnings[0].used.min_hz == 57.5e9);
    CHECK(warnings[0].text() == "marble: valid from 1 to 60 GHz, used from 57.5 to 61.3 GHz");
}

TEST_CASE("a number may have a source and a narrower band of its own", "[validity]") {
    const MadeUpFolder folder;
    const Material material = read_material(
        folder.with("iron.toml", number("evidence = 'estimate'\nvalid_ghz = [50, 60]\n")));
    REQUIRE(material.numbers.size() == 1);
    CHECK(material.numbers[0].source == "a guess");
    CHECK(material.valid_at(55e9));
    CHECK_FALSE(material.valid_at(70e9));
    const auto warnings = band_warnings(material, {57e9, 61e9});
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].text() ==
          "iron, permeability: valid from 50 to 60 GHz, used from 57 to 61 GHz");
    CHECK(band_warnings(material, {1e9, 400e9}).size() == 1);  // nothing of it holds: said once
}

TEST_CASE("a number without a band has that of its file", "[validity]") {
    const MadeUpFolder folder;
    const Material material = read_material(folder.with("iron.toml", number("")));
    CHECK(material.numbers[0].valid.min_hz == 20e9);
    CHECK(material.numbers[0].evidence == Evidence::estimate);
}

TEST_CASE("the source of a number that the file does not have is refused", "[validity]") {
    const MadeUpFolder folder;
    const auto file =
        folder.with("iron.toml", edited(number(""), "key = 'permeability'", "key = 'permitivity'"));
    CHECK(message_of([&] {
              return read_material(file);
          }).find(":8: number.key = \"permitivity\": is not a key of this file") !=
          std::string::npos);
}

TEST_CASE("whoever does not say where numbers come from is estimating", "[validity]") {
    const MadeUpFolder folder;
    CHECK(read_material(folder.with("a.toml", metal)).evidence == Evidence::estimate);
    CHECK(read_material(folder.with("b.toml", metal)).group == "other");
    CHECK(message_of([&] {
              return read_material(folder.with("c.toml", "evidence = 'rumour'\n" + metal));
          }).find("use \"recommendation\", \"literature\" or \"estimate\"") != std::string::npos);
}

TEST_CASE("warnings of several materials come once each, and air and metal have none",
          "[validity]") {
    const auto warnings = band_warnings(
        library(), {"marble", "plywood", "marble", "air", "metal", "plexiglass"}, {57e9, 64e9});
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0].material == "marble");
    CHECK(warnings[1].material == "plywood");
}

TEST_CASE("a scene warns of its layers and its backing at the radar's frequencies", "[validity]") {
    Scene scene;
    scene.sample.material = "plexiglass";
    CHECK(band_warnings(scene, library()).empty());
    scene.sample.backing = "plywood";
    CHECK(band_warnings(scene, library()).size() == 1);
    scene.sample.layers = {{"brick", 0.01}, {"plexiglass", 0.005}};
    const auto warnings = band_warnings(scene, library());
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0].material == "brick");
    CHECK(warnings[0].used.min_hz == scene.radar.chirp.frequency_hz(0));
}

}  // namespace
}  // namespace specula
