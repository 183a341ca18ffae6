#include <set>

#include "tests/check.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

namespace fs = std::filesystem;

const std::string swept_plate = SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml";

TEST_CASE("sweep writes a table twice and a figure per axis, and show reads it",
          "[program][sweep]") {
    const TemporaryFolder folder;
    const Ended swept = specula_in(folder.path(), {"sweep", swept_plate, "--tilt", "0:4:2",
                                                   "--tilted", "sample", "--size", "50"});
    REQUIRE(swept.status == 0);
    CHECK(swept.output.find("3 rows. Wrote table.csv, table.h5, level_over_tilt.svg") !=
          std::string::npos);
    std::set<std::string> written;
    for (const auto& entry : fs::directory_iterator(folder / "out/sweep/metal_plate"))
        written.insert(entry.path().filename().string());
    CHECK(written == std::set<std::string>{"table.csv", "table.h5", "level_over_tilt.csv",
                                           "level_over_tilt.png", "level_over_tilt.svg"});
    const std::string csv = content_of(folder / "out/sweep/metal_plate/table.csv");
    CHECK(csv.rfind("specimen,thickness_mm,", 0) == 0);
    CHECK(csv.find("nan") == std::string::npos);
    const Ended shown = specula_in(folder.path(), {"show", "out/sweep/metal_plate/table.h5"});
    CHECK(shown.status == 0);
    CHECK(shown.output.find("Sweep of metal_plate, 3 rows") != std::string::npos);
    CHECK(shown.output.find("over_untilted_db") != std::string::npos);
}

TEST_CASE("a sweep that is refused writes nothing and says why in one line", "[program][sweep]") {
    const MadeUpFolder folder;
    const auto errors = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "sweep");
        const Ended ended = specula_in(folder.path(), arguments);
        CHECK(ended.status == 2);
        CHECK(ended.output.empty());
        CHECK(std::count(ended.errors.begin(), ended.errors.end(), '\n') == 1);
        CHECK_FALSE(fs::exists(folder / "out"));
        return ended.errors;
    };
    CHECK(errors({swept_plate, "--tilt", "10:0:1"}).find("--tilt = 10:0:1: runs backwards") !=
          std::string::npos);
    CHECK(errors({swept_plate, "--height", "20"}).find("--height = 20: 20 mm is bin") !=
          std::string::npos);
    CHECK(errors({"tilt_and_sise"}).find("did you mean tilt_and_size?") != std::string::npos);
    CHECK(errors({"no_such.toml"}).find("no_such.toml") != std::string::npos);
    CHECK(errors({}).find("SCENE") != std::string::npos);
}

TEST_CASE("a folder that cannot be made is told before the sweep begins", "[program][sweep]") {
    const MadeUpFolder folder;
    folder.with("file", "");
    const Ended ended = specula_in(
        folder.path(), {"sweep", swept_plate, "--tilt", "0:80:0.1", "--out", "file/below"});
    CHECK(ended.status == 2);
    CHECK(ended.errors.find("file/below: cannot create") != std::string::npos);
}

}  // namespace
}  // namespace specula
