#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/run_program.hpp"
#include "tests/tools/specula/small_study.hpp"

namespace specula {
namespace {

Ended show(const std::string& what) {
    const TemporaryFolder folder;
    return specula_in(folder.path(), {"show", what});
}

TEST_CASE("a list has a heading, then a name at the beginning of each line", "[program][list]") {
    const TemporaryFolder folder;
    for (const auto& [kind, name, title] :
         {std::tuple{"materials", "plexiglass", "Plexiglass"},
          {"radars", "iwrl6432boost", "TI IWRL6432BOOST"},
          {"experiments", "paper", "Edge radar material classification"}}) {
        const Ended list = specula_in(folder.path(), {"list", kind});
        CHECK(list.status == 0);
        CHECK(list.errors.empty());
        CHECK(list.output.rfind("name ", 0) == 0);
        CHECK(contains(list.output, std::string("\n") + name + " "));
        CHECK(contains(list.output, title));
    }
}

TEST_CASE("show explains everything that is listed", "[program][show]") {
    const Ended material = show("plexiglass");
    CHECK(material.status == 0);
    CHECK(contains(material.output, "GHz"));
    CHECK(contains(material.output, "dB"));
    CHECK(contains(material.output, "2.6"));
    const Ended radar = show("iwrl6432boost");
    CHECK(radar.status == 0);
    CHECK(contains(radar.output, "range bin          3.904 cm, farthest range 2.248 m"));
    CHECK(contains(radar.output, "at 450 mm falls into bin 11.53, beat 450.3 kHz"));
    const Ended experiment = show("paper");
    CHECK(experiment.status == 0);
    CHECK(contains(experiment.output, "tilt_sample"));
    CHECK(contains(experiment.output, "5 classes, radar iwrl6432boost"));
}

TEST_CASE("show takes the kind before the name, and holds the name to it", "[program][show]") {
    const TemporaryFolder folder;
    const Ended material = specula_in(folder.path(), {"show", "material", "plexiglass"});
    CHECK(material.status == 0);
    CHECK(material.output == show("plexiglass").output);
    CHECK(specula_in(folder.path(), {"show", "radar", "iwrl6432boost"}).status == 0);
    const Ended mixed_up = specula_in(folder.path(), {"show", "radar", "plexiglass"});
    CHECK(mixed_up.status == 2);
    CHECK(contains(mixed_up.errors, "\"plexiglass\": no such radar; see specula list radars"));
    CHECK(specula_in(folder.path(), {"show", "matter", "plexiglass"}).status == 2);
}

TEST_CASE("show gives a material's reflection over frequency and over angle", "[program][show]") {
    // The Brewster angle is 58 degrees: TM falls by 20 dB there, TE does not.
    const Ended shown = show("plexiglass");
    CHECK(contains(shown.output, "      60          -6.70         -32.90"));
    CHECK(contains(shown.output, "      60           2.6 - j0.026"));
    CHECK_FALSE(contains(show("air").output, "inf"));  // nothing comes back from air in air
}

TEST_CASE("show explains a file by what is in it", "[program][show]") {
    const MadeUpFolder folder;
    const std::string root = SPECULA_SOURCE_DIR;
    CHECK(contains(show(root + "/materials/library/plexiglass.toml").output, "plexiglass"));
    CHECK(contains(show(root + "/scenes/radars/iwrl6432boost.toml").output, "range bin"));
    CHECK(contains(show(folder.with("x.toml", small_study).string()).output,
                   "Does it run?\n\n2 worlds, 2 classes"));
    // A scene's link budget is that of its own height, and its tilt is told.
    const std::string scene = project_file("scenes/examples/tilted_plexiglass.toml");
    const Ended shown =
        show(folder.with("scene.toml", edited(scene, "height_mm  = 450", "height_m = 1")).string());
    CHECK(contains(shown.output, "plexiglass, 150 x 150 mm, 5 mm thick, backed by air"));
    CHECK(contains(shown.output,
                   "the radar 1000 mm above it\n"
                   "sample tilted by 10 deg in azimuth, 0 deg in elevation\n"));
    CHECK_FALSE(contains(shown.output, "sensor tilted"));
    CHECK(contains(shown.output, "an infinite mirror at 1000 mm falls into bin 25.62"));
}

TEST_CASE("show explains every example", "[program][show]") {
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECULA_SOURCE_DIR "/scenes/examples")) {
        if (entry.path().extension() != ".toml") continue;  // meshes lie beside
        const Ended shown = show(entry.path().string());
        INFO(entry.path() << ": " << shown.errors);
        CHECK(shown.status == 0);
        CHECK(contains(shown.output, " mm above it\n"));
    }
}

TEST_CASE("show explains a dataset, its truth with units", "[program][show]") {
    const TemporaryFolder folder;
    REQUIRE(specula_in(
                folder.path(),
                {"simulate", SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml", "-o", "x.h5"})
                .status == 0);
    const Ended shown = specula_in(folder.path(), {"show", "x.h5"});
    CHECK(shown.status == 0);
    CHECK(contains(shown.output, "x.h5: 1 frames x 1 chirps x 3 RX x 128 samples"));
    CHECK(contains(shown.output, "aluminium"));
    CHECK(contains(shown.output, "height_m"));
    CHECK(contains(shown.output, "fingerprint "));
}

TEST_CASE("a dataset that is cut off, empty or garbage is refused, whatever the cut",
          "[program][show]") {
    const MadeUpFolder folder;
    REQUIRE(specula_in(folder.path(),
                       {"simulate", SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml", "-o",
                        "whole.h5"})
                .status == 0);
    const std::string whole = content_of(folder / "whole.h5");
    std::vector<std::string> broken{"", "garbage", "\x89HDF\r\n\x1a\n", std::string(5000, '\0')};
    for (const double share : {0.05, 0.3, 0.6, 0.9, 0.99})
        broken.push_back(
            whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    for (const std::string& bytes : broken) {
        folder.with("x.h5", bytes);
        const Ended shown = specula_in(folder.path(), {"show", "x.h5"});
        INFO(bytes.size() << " bytes: " << shown.errors);
        CHECK(shown.status == 2);
        CHECK(shown.output.empty());
        CHECK(shown.errors.rfind("specula: error: x.h5: ", 0) == 0);
        CHECK(shown.errors.find('\n') == shown.errors.size() - 1);
    }
}

TEST_CASE("what show does not know is refused with the nearest name", "[program][show]") {
    for (const auto& [what, message] :
         {std::pair{"plexiglas", "\"plexiglas\": nothing of that name; did you mean plexiglass?"},
          {"papre", "\"papre\": nothing of that name; did you mean paper?"},
          {"nothing_like_it",
           "\"nothing_like_it\": nothing of that name; see specula list materials, list radars and "
           "list experiments, or name a .toml, .cfg or .h5 file"},
          {"none.h5", "none.h5: no such file; check the path"},
          {"none.toml", "none.toml: no such file; check the path"}}) {
        const Ended shown = show(what);
        CHECK(shown.status == 2);
        CHECK(shown.output.empty());
        CHECK(shown.errors == std::string("specula: error: ") + message + "\n");
    }
}

}  // namespace
}  // namespace specula
