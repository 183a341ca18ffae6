#include "materials/ingredient.hpp"

#include "materials/library.hpp"
#include "materials/validity.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

const std::string head = "title = 'x'\nsource = 'y'\nvalid_ghz = [10, 100]\n";  // 3 lines

std::string constant(const std::string& permittivity) {
    return head + "model = 'constant'\npermittivity = " + permittivity + "\nloss_tangent = 0\n";
}

std::string mixture(const std::string& host, const std::string& inclusion) {
    return head + "model = 'mixture'\nhost = '" + host + "'\ninclusion = '" + inclusion +
           "'\nvolume_fraction = 0.5\nlaw = 'lichtenecker'\n";
}

TEST_CASE("a mixture finds its parts whatever the order of the files", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("a.toml", mixture("z", "m"));  // read first, made of what comes later
    folder.with("m.toml", mixture("z", "b"));
    folder.with("b.toml", constant("1"));
    folder.with("z.toml", constant("16"));
    const Library library(folder.path());
    CHECK(library.find("m")->at(60e9).permittivity.real() == Approx(4.0));
    CHECK(library.find("a")->at(60e9).permittivity.real() == Approx(8.0));
}

TEST_CASE("a material made of itself is refused with the whole circle", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("a.toml", mixture("b", "b"));
    folder.with("b.toml", mixture("c", "c"));
    folder.with("c.toml", mixture("a", "a"));
    CHECK(message_of([&] { return Library(folder.path()); }) ==
          (folder / "c.toml").string() +
              ":5: host = \"a\": makes the material a part of itself: a -> b -> c -> a; "
              "name one that does not contain this one");
    folder.with("a.toml", mixture("a", "a"));
    CHECK(message_of([&] { return Library(folder.path()); }).find("part of itself: a -> a;") !=
          std::string::npos);
}

TEST_CASE("one material may be a part of many, and twice of one", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("a.toml", mixture("x", "x")).parent_path();
    folder.with("b.toml", mixture("x", "a"));
    folder.with("x.toml", constant("3"));
    CHECK(Library(folder.path()).find("b")->at(60e9).permittivity.real() == Approx(3.0));
}

TEST_CASE("an unknown part is refused, and the nearest name offered", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("a.toml", mixture("limestone", "watr"));
    folder.with("limestone.toml", constant("7"));
    folder.with("water.toml", constant("9"));
    CHECK(message_of([&] {
              return Library(folder.path());
          }).find("a.toml:6: inclusion = \"watr\": is not known; did you mean \"water\"?") !=
          std::string::npos);
}

TEST_CASE("a part may be described in place, and have parts itself", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("x.toml", constant("1"));
    folder.with("a.toml", head +
                              "model = 'mixture'\nlaw = 'lichtenecker'\ninclusion = 'x'\n"
                              "volume_fraction = 0.5\n"
                              "[host]\nmodel = 'mixture'\nlaw = 'lichtenecker'\n"
                              "inclusion = 'x'\nvolume_fraction = 0.5\n"
                              "[host.host]\nmodel = 'constant'\npermittivity = 16\n"
                              "loss_tangent = 0\n");
    CHECK(Library(folder.path()).find("a")->at(60e9).permittivity.real() == Approx(2.0));
}

TEST_CASE("a key that no part knows is refused where it stands", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("x.toml", constant("1"));
    folder.with("a.toml", head +
                              "model = 'mixture'\ninclusion = 'x'\nvolume_fraction = 0.5\n"
                              "[host]\nmodel = 'constant'\npermittivity = 16\n"
                              "loss_tangent = 0\nlos = 1\n");
    CHECK(message_of([&] { return Library(folder.path()); }).find("a.toml:11: host.los = 1:") !=
          std::string::npos);
}

TEST_CASE("a metal is no part of a mixture", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("iron.toml", head +
                                 "model = 'conductive'\nconductivity_s_per_m = 1e7\n"
                                 "permeability = 1\n");
    folder.with("a.toml", mixture("x", "iron"));
    folder.with("x.toml", constant("2"));
    CHECK(message_of([&] {
              return Library(folder.path());
          }).find("inclusion = \"iron\": is a metal") != std::string::npos);
}

TEST_CASE("a file outside the library may name what is in it", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("library/x.toml", constant("9"));
    const Library library(folder / "library");
    const auto file = folder.with("mine.toml", mixture("x", "x"));
    CHECK(read_material(file, library.lookup()).at(60e9).permittivity.real() == Approx(9.0));
    CHECK(message_of([&] {
              return read_material(file);
          }).find("names another material, and there is no library at hand") != std::string::npos);
}

TEST_CASE("a mixture is as valid as the least valid of its parts", "[ingredient]") {
    const MadeUpFolder folder;
    folder.with("narrow.toml", edited(constant("2"), "[10, 100]", "[50, 60]"));
    folder.with("wide.toml", constant("3"));
    folder.with("a.toml", mixture("narrow", "wide"));
    const Library library(folder.path());
    CHECK(library.find("a")->valid_at(55e9));
    CHECK_FALSE(library.find("a")->valid_at(61e9));
    const auto warnings = band_warnings(*library.find("a"), {57e9, 61e9});
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].material == "narrow");
}

}  // namespace
}  // namespace specula
