#include <algorithm>
#include <filesystem>
#include <fstream>

#include "sim/dataset/dataset.hpp"
#include "sim/dataset/sha256.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/run_program.hpp"

namespace specula {
namespace {

TEST_CASE("generate says what it will take, writes, and finds its work done the next time",
          "[program]") {
    const TemporaryFolder folder;
    const std::vector<std::string> command{"generate", "sheets_and_boards", "--worlds", "1", "-o",
                                           "a.h5"};
    const Ended first = specula_in(folder.path(), command);
    INFO(first.errors);
    REQUIRE(first.status == 0);
    CHECK(contains(first.output, "192 frames in 1 shards: about "));
    CHECK(contains(first.output, "Wrote a.h5: 192 frames"));
    CHECK(contains(first.output, "Beside it a.DATASHEET.md and a.croissant.json\n"));
    CHECK(std::filesystem::exists(folder / "a.DATASHEET.md"));
    CHECK(std::filesystem::exists(folder / "a.croissant.json"));
    const std::string fingerprint = first.output.substr(first.output.find("fingerprint "), 28);
    const Dataset made = read_dataset(folder / "a.h5");
    CHECK(made.n_frames() == 192);
    CHECK(made.adc.empty());
    CHECK(made.n_profile_bins == 32);
    CHECK(made.class_names == std::vector<std::string>{"glass", "plasterboard"});

    const Ended again = specula_in(folder.path(), command);
    CHECK(again.status == 0);
    CHECK(contains(again.output, "Everything was recorded already.\nWrote a.h5: 192 frames"));
    CHECK(contains(again.output, fingerprint));
    CHECK_FALSE(contains(again.output, "Beside it"));  // they are of these very bytes

    // What the document tells of the file is evidence: it is neither overlooked nor rewritten.
    const std::string hash = sha256_of_file(folder / "a.h5");
    std::string json = content_of(folder / "a.croissant.json");
    json.replace(json.find(hash), 4, hash.substr(0, 4) == "0000" ? "1111" : "0000");
    std::ofstream(folder / "a.croissant.json") << json;
    const Ended damaged = specula_in(folder.path(), command);
    CHECK(damaged.status == 2);
    CHECK(damaged.errors ==
          "specula: error: a.h5: is damaged: its SHA-256 is not the one that a.croissant.json tells; "
          "remove it, and the same command makes it again\n");
    CHECK(content_of(folder / "a.croissant.json") == json);
    std::filesystem::remove(folder / "a.croissant.json");
    CHECK(contains(specula_in(folder.path(), command).output,
                   "No Croissant metadata beside it told its SHA-256"));
    const std::string whole = content_of(folder / "a.h5");
    std::ofstream(folder / "a.h5", std::ios::app) << "junk";
    const Ended longer = specula_in(folder.path(), command);
    CHECK(longer.status == 2);
    CHECK(contains(longer.errors, "a.h5: file: goes on for 4 bytes after the end that it tells"));
    CHECK(contains(longer.errors, "remove it, and the same command makes it again"));
    std::ofstream(folder / "a.h5", std::ios::trunc) << whole;

    std::vector<std::string> other = command;
    other.insert(other.end(), {"--seed", "4"});
    const Ended refused = specula_in(folder.path(), other);
    CHECK(refused.status == 2);
    CHECK(refused.errors ==
          "specula: error: a.h5: was made otherwise: seed = 3 there, 4 here; give back the same "
          "settings, or name another output\n");
}

TEST_CASE("shares print the command that merges them, and merge makes the file", "[program]") {
    const TemporaryFolder folder;
    for (const std::string share : {"0/2", "1/2"}) {
        const Ended ended = specula_in(folder.path(), {"generate", "sheets_and_boards", "--worlds",
                                                       "1", "-o", "a.h5", "--shard", share});
        INFO(ended.errors);
        CHECK(ended.status == 0);
        CHECK(contains(ended.output, "specula merge a.h5.parts -o a.h5"));
        CHECK(contains(ended.output, "Share " + share + " is done"));
    }
    const Ended deep = specula_in(folder.path(), {"merge", "a.h5.parts", "-o", "new/deep/b.h5"});
    INFO(deep.errors);
    CHECK(deep.status == 0);
    const Ended merged = specula_in(folder.path(), {"merge", "a.h5.parts", "-o", "a.h5"});
    INFO(merged.errors);
    CHECK(merged.status == 0);
    CHECK(contains(merged.output, "Wrote a.h5: 192 frames of 1 shards"));
    CHECK(contains(content_of(folder / "a.DATASHEET.md"), "# Datasheet of a.h5"));
    CHECK(contains(content_of(folder / "a.croissant.json"), sha256_of_file(folder / "a.h5")));
}

TEST_CASE("the documents of a folder name its shards and their hashes", "[program]") {
    const TemporaryFolder folder;
    const std::vector<std::string> command{"generate", "sheets_and_boards", "--worlds", "1", "-o",
                                           "kept/"};
    REQUIRE(specula_in(folder.path(), command).status == 0);
    CHECK(std::filesystem::exists(folder / "kept/DATASHEET.md"));
    const std::string json = content_of(folder / "kept/croissant.json");
    for (const std::string name : {"index.h5", "manifest.sha256", "shard-000000.h5"}) {
        INFO(name);
        CHECK(contains(json, "\"contentUrl\": \"" + name + "\""));
        CHECK(contains(json, sha256_of_file(folder / ("kept/" + name))));
    }
    // A damaged shard is described no more.
    std::fstream(folder / "kept/shard-000000.h5", std::ios::in | std::ios::out).seekp(3000).put('X');
    const Ended bad = specula_in(folder.path(), {"export", "croissant", "kept"});
    INFO(bad.errors);
    CHECK(bad.status == 2);
    CHECK(contains(bad.errors, "kept/"));
}

TEST_CASE("what generate cannot do is told in one line that says what would do", "[program]") {
    const TemporaryFolder folder;
    const std::string too_long(300, 'a');
    struct Case {
        std::vector<std::string> arguments;
        std::string message;
    };
    for (const auto& [arguments, message] : std::vector<Case>{
             {{"generate", "sheets_and_board"}, "did you mean sheets_and_boards?"},
             {{"generate", "paper", "--condition", "hight", "-o", "a.h5"}, "use \"training\", "},
             {{"generate", "paper", "--shard", "8/8", "-o", "a.h5"}, "0/8 to 7/8"},
             {{"generate", "paper", "--shard", "env", "-o", "a.h5"}, "sbatch --array or mpirun"},
             {{"generate", "paper", "--store", "adc,features,adc", "-o", "a.h5"}, "\"adc\" twice"},
             {{"generate", "none.toml", "-o", "a.h5"}, "none.toml: "},
             {{"merge", "nowhere", "-o", "a.h5"}, "nowhere: no such folder"},
             {{"generate", "paper", "-o", too_long}, too_long + ": File name too long; give another"},
             {{"merge", ".", "-o", "a.h5"}, ".: holds no shards"}}) {
        const Ended ended = specula_in(folder.path(), arguments);
        INFO(ended.errors);
        CHECK(ended.status == 2);
        CHECK(contains(ended.errors, message));
        CHECK(std::count(ended.errors.begin(), ended.errors.end(), '\n') == 1);
        CHECK(std::filesystem::is_empty(folder.path()));
    }
}

TEST_CASE("a folder that takes no files is named with the reason", "[program]") {
    const TemporaryFolder folder;
    const Ended ended =
        specula_in(folder.path(), {"generate", "sheets_and_boards", "-o", "/proc/specula/a.h5"});
    CHECK(ended.status == 1);
    CHECK(contains(ended.errors, "/proc/specula/a.h5.parts: cannot create: No such file"));
}

}  // namespace
}  // namespace specula
