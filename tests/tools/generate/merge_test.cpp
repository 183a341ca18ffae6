#include "tools/generate/merge.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"
#include "tests/tools/generate/small_recipe.hpp"

namespace specula {
namespace {

namespace fs = std::filesystem;

/// Three shares of a run in folders of their own, as from three machines.
class ThreeMachines {
  public:
    ThreeMachines() {
        for (std::size_t index = 0; index < 3; ++index) {
            fs::create_directory(folder(index));
            run_generate(small.read(), {.out = folder(index), .share = {index, 3}, .say = {}},
                         own_catalogue().materials);
        }
    }
    fs::path folder(std::size_t index) const {
        return small.folder / ("machine-" + std::to_string(index));
    }
    std::string refusal(const std::vector<fs::path>& folders) const {
        return message_of([&] { return run_merge({folders, small.folder / "all.h5"}); });
    }
    const SmallRecipe small;
};

/// The number of a process that has ended.
std::string ended_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return std::to_string(child);
}

TEST_CASE("shards of several machines merge, in any order of the folders", "[generate]") {
    const ThreeMachines machines;
    const fs::path left = machines.small.folder / ("all.h5.draft-" + ended_process());
    std::ofstream(left) << "half, killed";
    const MergeReport report =
        run_merge({{machines.folder(2), machines.folder(0), machines.folder(1)},
                   machines.small.folder / "all.h5"});
    CHECK_FALSE(fs::exists(left));
    CHECK(report.n_shards == 3);
    CHECK(report.n_frames == machines.small.read().n_frames());
    CHECK(contains(machines.refusal({machines.folder(0), machines.folder(1), machines.folder(2)}),
                   "is there already"));
}

TEST_CASE("a merge names what is missing, twice there, foreign or damaged", "[generate]") {
    const ThreeMachines machines;
    const fs::path shard = machines.folder(1) / "shard-000001.h5";
    CHECK(machines.refusal({machines.folder(0), machines.folder(2)}) ==
          "sessions 64 to 127 of 160 are missing; run the generate commands that make them");

    fs::copy(machines.folder(1), machines.small.folder / "copy");
    CHECK(contains(machines.refusal({machines.folder(0), machines.folder(1), machines.folder(2),
                                     machines.small.folder / "copy"}),
                   "holds sessions 64 to 127 a second time, beside "));

    fs::create_directory(machines.small.folder / "other");
    run_generate(machines.small.read({.seed = 6}),
                 {.out = machines.small.folder / "other", .share = {1, 3}, .say = {}},
                 own_catalogue().materials);
    CHECK(contains(
        machines.refusal({machines.folder(0), machines.small.folder / "other", machines.folder(2)}),
        "other/shard-000001.h5: is of another run than"));

    const std::string whole = bytes_of(shard);
    std::string damaged = whole;
    damaged[damaged.size() / 2] ^= 1;
    std::ofstream(shard, std::ios::binary | std::ios::trunc) << damaged;
    CHECK(contains(machines.refusal({machines.folder(0), machines.folder(1), machines.folder(2)}),
                   "shard-000001.h5: "));
    CHECK_FALSE(fs::exists(machines.small.folder / "all.h5"));

    std::ofstream(shard, std::ios::binary | std::ios::trunc) << whole;
    fs::remove(machines.folder(1) / "manifest-1-of-3.sha256");
    CHECK(contains(machines.refusal({machines.folder(0), machines.folder(1), machines.folder(2)}),
                   "shard-000001.h5: no manifest tells its hash"));
    CHECK(contains(machines.refusal({machines.small.folder / "nowhere"}), "no such folder"));
}

}  // namespace
}  // namespace specula
