#include "tests/check.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

const std::string plate = SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml";

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

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

TEST_CASE("the same seed gives the same file, another one other noise", "[program][simulate]") {
    const TemporaryFolder folder;
    const auto bytes = [&](const std::string& seed) {
        const std::string name = "seed" + seed + ".h5";
        std::filesystem::remove(folder / name);
        REQUIRE(specula_in(folder.path(), {"simulate", plate, "-o", name, "--seed", seed}).status ==
                0);
        return content_of(folder / name);
    };
    const std::string first = bytes("3");
    CHECK(bytes("3") == first);
    CHECK(bytes("4") != first);
}

TEST_CASE("a dataset that cannot be written is named, and no draft stays", "[program][simulate]") {
    const MadeUpFolder folder;
    folder.with("file", "kept");
    std::filesystem::create_directory(folder / "taken");
    for (const auto& [out, beginning] :
         {std::pair{"file/x.h5", "file/x.h5: cannot create: "},
          {"none/x.h5", "none/x.h5: cannot create: "},
          {"/proc/x.h5", "/proc/x.h5: cannot create: "},
          {"taken", "taken: cannot replace: Is a directory"}}) {
        const Ended ended = specula_in(folder.path(), {"simulate", plate, "--out", out});
        CHECK(ended.status == 1);
        CHECK(ended.errors.rfind(std::string("specula: error: ") + beginning, 0) == 0);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
    }
    const std::filesystem::directory_iterator left(folder.path());
    CHECK(std::distance(begin(left), end(left)) == 2);
    CHECK(content_of(folder / "file") == "kept");
}

TEST_CASE("every example can be simulated", "[program][simulate]") {
    for (const auto& entry :
         std::filesystem::directory_iterator(SPECULA_SOURCE_DIR "/scenes/examples")) {
        const TemporaryFolder folder;
        const Ended ended = specula_in(folder.path(), {"simulate", entry.path().string()});
        INFO(entry.path() << ": " << ended.errors);
        CHECK(ended.status == 0);
    }
}

}  // namespace
}  // namespace specula
