#include "tests/check.hpp"
#include "tests/run_program.hpp"

// A user's scene_mistakes in a scene file, through the program: exit status 2, one line that names
// the place, the key, the value and a way out, and no file written.

namespace specula {
namespace {

const std::string scene = project_file("scenes/examples/tilted_plexiglass.toml");

/// Line of a text in the scene, from 1.
std::string line_of(const std::string& text, const std::string& part) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(part));
    return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

struct SceneMistake {
    std::string from, to;  ///< what became what in the example
    std::string at;        ///< its line is that of the first text like this
    std::string message;   ///< begins with
};

const std::vector<SceneMistake> scene_mistakes{
    {"height_mm  = 450", "height_mm = -3", "height_mm",
     "geometry.height_mm = -3: is out of range; give a value above 0 mm and below 100000 mm"},
    {"tilt_deg   = 10", "tilt_deg = 95", "tilt_deg",
     "geometry.tilt_deg = 95: is out of range; give a value at least -85 deg and at most 85 deg"},
    {"tilt_deg   = 10", "tilt_deg = 90", "tilt_deg",
     "geometry.tilt_deg = 90: is out of range; give a value at least -85 deg and at most 85 deg"},
    {"thickness_mm = 5", "thickness_mm = 0", "thickness_mm",
     "sample.thickness_mm = 0: is out of range; give a value above 0 mm and below 1000 mm"},
    {"\"plexiglass\"", "\"plexiglas\"", "\"plexiglas\"",
     "sample.material = \"plexiglas\": is not known; did you mean \"plexiglass\"?"},
    {"tilt_deg ", "tlit_deg ", "tlit_deg",
     "geometry.tlit_deg = 10: is not a key of this table; did you mean tilt_deg?"},
    {"tilt_deg   = 10", "tilt_deg = \"10\"", "tilt_deg",
     "geometry.tilt_deg = \"10\": is not a number; give a number at least -85 deg and at most 85 "
     "deg"},
    {"bow_mm       = 0.2", "bow_mm = nan", "bow_mm",
     "sample.bow_mm = nan: is not a finite number; give a value at least -50 mm and at most 50 mm"},
    {"height_mm  = 450", "height_mm = ", "height_mm", "not valid TOML: "},
    {"[sample]", "[sample", "[sample", "not valid TOML: "},
    {"height_mm  = 450", "height_m = 5", "height_m",
     "geometry.height_m = 5: is beyond the farthest range of the chirp of iwrl6432boost, 2.25 m; "
     "choose a height of 118 to 2248 mm, or another radar"},
    {"height_mm  = 450", "height_cm = 5", "height_cm",
     "geometry.height_cm = 5: is bin 1.28 of the chirp of iwrl6432boost, among bins 0 to 2, "
     "where boards leak; choose a height of 118 to 2248 mm, or another radar"},
    {"height_mm  = 450", "height_mm = 450\nheight_cm = 45", "height_cm",
     "geometry.height_cm = 45: is given twice, as geometry.height_mm too; keep one of them"},
    {"tilted     = \"sample\"", "tilted = \"sensor\"", "pivot_mm",
     "geometry.pivot_mm = [0, 0, 0]: a tilted sensor turns about its own phase centre; "
     "remove it, or write tilted = \"sample\""},
    {"height_mm  = 450", "height = 450", "height",
     "geometry.height = 450: has no unit; write height_mm, height_m, height_cm or height_um"},
    {"[geometry]", "[geometrie]",
     "radar = ", "geometry: is missing; add it, or is it meant by geometrie in line "},
    {"\"iwrl6432boost\"", "\"iwrl6432\"", "radar = ", "radar = \"iwrl6432\": is not known; "},
    {"\"iwrl6432boost\"", "\"none.toml\"", "radar = ",
     "radar = \"none.toml\": no such file beside this one; give a path relative to this file"},
};

TEST_CASE("each mistake in a scene is one line that says where, what and what would do",
          "[program][bad scene]") {
    for (const SceneMistake& mistake : scene_mistakes) {
        const MadeUpFolder folder;
        const std::string text = edited(scene, mistake.from, mistake.to);
        folder.with("scene.toml", text);
        const Ended ended = specula_in(folder.path(), {"simulate", "scene.toml"});
        INFO(ended.errors);
        CHECK(ended.status == 2);
        CHECK(ended.output.empty());
        // A key that is missing is looked for in the whole file: line 1.
        const bool missing = mistake.message.find(": is missing") != std::string::npos;
        const std::string line = missing ? "1" : line_of(text, mistake.at);
        const std::string expected = "specula: error: scene.toml:" + line + ": " + mistake.message;
        CHECK(ended.errors.substr(0, expected.size()) == expected);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
        CHECK(ended.errors.find("; ") != std::string::npos);  // a remedy
        const std::filesystem::directory_iterator left(folder.path());
        CHECK(std::distance(begin(left), end(left)) == 1);  // the scene alone
    }
}

TEST_CASE("a scene that is no file is refused", "[program][bad scene]") {
    const MadeUpFolder folder;
    std::filesystem::create_directory(folder / "folder.toml");
    folder.with("data.h5", "\x89HDF\r\n\x1a\n");
    for (const auto& [name, message] :
         {std::pair{"none.toml", "none.toml: no such file; check the path"},
          {"folder.toml", "folder.toml: is not a regular file; name a TOML file"},
          {"data.h5", "data.h5:1: not valid TOML: "}}) {
        const Ended ended = specula_in(folder.path(), {"simulate", name, "--out", "x.h5"});
        CHECK(ended.status == 2);
        CHECK(ended.errors.rfind(std::string("specula: error: ") + message, 0) == 0);
        CHECK_FALSE(std::filesystem::exists(folder / "x.h5"));
    }
}

TEST_CASE("a mistake in a radar beside the scene is told in the radar's file",
          "[program][bad scene]") {
    const MadeUpFolder folder;
    folder.with("radars/mine.toml", edited(project_file("scenes/radars/iwrl6432boost.toml"),
                                           "n_samples        = 128", "n_samples = 100"));
    folder.with("scene.toml", edited(scene, "iwrl6432boost", "radars/mine.toml"));
    const Ended ended = specula_in(folder.path(), {"simulate", "scene.toml"});
    CHECK(ended.status == 2);
    CHECK(ended.errors.rfind("specula: error: radars/mine.toml:", 0) == 0);
    CHECK(ended.errors.find("chirp.n_samples = 100: is not a power of two") != std::string::npos);
}

}  // namespace
}  // namespace specula
