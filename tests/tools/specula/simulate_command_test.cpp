#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

const std::string plate = SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml";

TEST_CASE("a simulated plate stands in the range bin of its height", "[program][simulate]") {
    const TemporaryFolder folder;
    const Ended ended = specula_in(folder.path(), {"simulate", plate});
    INFO(ended.errors);
    REQUIRE(ended.status == 0);
    CHECK(ended.errors.empty());
    CHECK(contains(ended.output, "at 450 mm: bin 11.53 of 39.04 mm each"));
    CHECK(contains(ended.output, "Wrote metal_plate.h5"));
    CHECK(std::filesystem::exists(folder / "metal_plate.h5"));
    // The longest bar behind the leakage is that of bin 11 or 12: 2 B R / c = 11.53.
    const auto bar = [&](const std::string& bin) {
        const auto at = ended.output.find("bin " + bin + " ");
        const std::string line = ended.output.substr(at, ended.output.find('\n', at) - at);
        return std::count(line.begin(), line.end(), '#');
    };
    for (const char* other : {" 8", " 9", "14", "15", "20"})
        CHECK(bar(other) < std::max(bar("11"), bar("12")) - 5);
}

TEST_CASE("the same seed gives the same codes, another one other noise", "[program][simulate]") {
    const TemporaryFolder folder;
    const auto fingerprint = [&](const std::string& seed) {
        REQUIRE(
            specula_in(folder.path(), {"simulate", plate, "-o", "x.h5", "--seed", seed}).status ==
            0);
        const std::string shown = specula_in(folder.path(), {"show", "x.h5"}).output;
        return shown.substr(shown.find("fingerprint "), 28);
    };
    const std::string first = fingerprint("3");
    CHECK(fingerprint("3") == first);
    CHECK(fingerprint("4") != first);
}

TEST_CASE("a far sample is in the chart too", "[program][simulate]") {
    const MadeUpFolder folder;
    folder.with("far.toml", edited(content_of(plate), "height_mm = 450", "height_m = 1.5"));
    const Ended ended = specula_in(folder.path(), {"simulate", "far.toml"});
    CHECK(contains(ended.output, "at 1500 mm: bin 38.43 of 39.04 mm each"));
    CHECK(contains(ended.output, "\nbin 38  148.3 cm "));
    CHECK(contains(ended.output, "\nbin 39  152.2 cm "));
}

TEST_CASE("a scene is never overwritten by its own dataset", "[program][simulate]") {
    const MadeUpFolder folder;
    folder.with("x.toml", content_of(plate));
    const Ended ended = specula_in(folder.path(), {"simulate", "x.toml", "-o", "./x.toml"});
    CHECK(ended.status == 2);
    CHECK(ended.errors ==
          "specula: error: ./x.toml: is an input of this command; give --out another name\n");
    const bool kept = content_of(folder / "x.toml") == content_of(plate);
    CHECK(kept);
}

TEST_CASE("a dataset that cannot be written is named, and no draft stays", "[program][simulate]") {
    const MadeUpFolder folder;
    folder.with("file", "kept");
    std::filesystem::create_directory(folder / "taken");
    struct Bad {
        const char* out;
        const char* beginning;
    };
    for (const auto& [out, beginning] :
         {Bad{"file/x.h5", "file: cannot create: "},
          Bad{"/proc/none/x.h5", "/proc/none: cannot create: "},
          Bad{"/proc/x.h5", "/proc/x.h5: cannot create: "},
          Bad{"taken", "taken: is there, and is no file; give another name"}}) {
        const Ended ended = specula_in(folder.path(), {"simulate", plate, "--out", out});
        CHECK(ended.status == 2);
        CHECK(ended.errors.rfind(std::string("specula: error: ") + beginning, 0) == 0);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
    }
    const std::filesystem::directory_iterator left(folder.path());
    CHECK(std::distance(begin(left), end(left)) == 2);
    CHECK(content_of(folder / "file") == "kept");
}

}  // namespace
}  // namespace specula
