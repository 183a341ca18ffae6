#include "scenes/catalogue.hpp"

#include <algorithm>

#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"

namespace specula {
namespace {

Section parse(const std::string& text) {
    return Section::parse(text, "x.toml");
}

TEST_CASE("the catalogue knows what lies in its folders, sorted", "[catalogue]") {
    for (const auto& names : {catalogue().radar_names(), catalogue().experiment_names(),
                              catalogue().materials.names()}) {
        CHECK_FALSE(names.empty());
        CHECK(std::is_sorted(names.begin(), names.end()));
    }
    CHECK(std::filesystem::exists(catalogue().experiment_file("paper")));
}

TEST_CASE("files that are not descriptions are not listed", "[catalogue]") {
    const MadeUpFolder folder;
    folder.with("scenes/radars/b.toml", "");
    folder.with("scenes/radars/a.toml", "");
    folder.with("scenes/radars/notes.txt", "");
    folder.with("scenes/radars/b.toml~", "");
    std::filesystem::create_symlink("someone@somewhere.1", folder / "scenes/radars/.#b.toml");
    folder.with("scenes/experiments/x", "");
    std::filesystem::create_directories(folder / "materials/library");
    const Catalogue made_up = Catalogue::open(folder.path());
    CHECK(made_up.radar_names() == std::vector<std::string>{"a", "b"});
    CHECK(made_up.experiment_names().empty());
    CHECK(made_up.materials.names().empty());
}

TEST_CASE("a folder that is no catalogue is refused with the part it lacks", "[catalogue]") {
    const MadeUpFolder folder;
    CHECK(message_of([&] { return Catalogue::open(folder.path()); }) ==
          (folder / "materials/library").string() +
              ": no such folder; set SPECULA_HOME to the folder that holds it");
}

TEST_CASE("a radar is found by name, or as a file beside the one that names it", "[catalogue]") {
    const MadeUpFolder folder;
    folder.with("own/mine.toml", project_file("scenes/radars/iwrl6432boost.toml"));
    folder.with("scene.toml",
                "radar = 'own/mine.toml'\nmissing = 'none.toml'\n"
                "name = 'iwrl6432boost'\nmisspelt = 'iwrl6432boots'");
    Section section = Section::read(folder / "scene.toml");
    CHECK(catalogue().radar(section, "radar").name == "mine");
    CHECK(catalogue().radar(section, "name").name == "iwrl6432boost");
    CHECK(message_of([&] { return catalogue().radar(section, "missing"); }) ==
          (folder / "scene.toml").string() +
              ":2: missing = \"none.toml\": no such file beside this one; "
              "give a path relative to this file");
    CHECK(message_of([&] {
              return catalogue().radar(section, "misspelt");
          }).find("is not known; did you mean \"iwrl6432boost\"?") != std::string::npos);
}

TEST_CASE("a backing is air, metal or a material, and air where none is given", "[catalogue]") {
    Section section = parse("a = 'metal'\nb = 'wood'\nc = 'woood'");
    CHECK(catalogue().backing_name(section, "none") == "air");
    CHECK(catalogue().backing_name(section, "a") == "metal");
    CHECK(catalogue().backing_name(section, "b") == "wood");
    CHECK(message_of([&] {
              return catalogue().backing_name(section, "c");
          }).rfind("x.toml:3: c = \"woood\": is not known; did you mean \"wood\"?", 0) == 0);
}

TEST_CASE("a material is one of the library", "[catalogue]") {
    Section section = parse("a = 'wood'\nb = 'plexiglas'");
    CHECK(catalogue().material_name(section, "a") == "wood");
    CHECK(message_of([&] {
              return catalogue().material_name(section, "b");
          }).rfind("x.toml:2: b = \"plexiglas\": is not known; did you mean \"plexiglass\"?", 0) ==
          0);
}

}  // namespace
}  // namespace specula
