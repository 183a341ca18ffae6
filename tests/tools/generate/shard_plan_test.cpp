#include "tools/generate/shard_plan.hpp"

#include <map>

#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/tools/generate/small_recipe.hpp"

namespace specula {
namespace {

using Variables = std::map<std::string, std::string>;

Share share(const std::string& text, const Variables& variables = {}) {
    return read_share(text, [&](const std::string& name) {
        const auto found = variables.find(name);
        return found == variables.end() ? std::string() : found->second;
    });
}

TEST_CASE("shards tile the sessions of a run", "[generate]") {
    for (const ShardPlan plan : {ShardPlan{160, 64}, ShardPlan{1, 64}, ShardPlan{128, 64}}) {
        std::size_t end = 0;
        for (std::size_t shard = 0; shard < plan.n_shards(); ++shard) {
            CHECK(plan.span(shard).first == end);
            CHECK(plan.span(shard).count > 0);
            end = plan.span(shard).end();
        }
        CHECK(end == plan.n_sessions);
    }
}

TEST_CASE("no shard holds more than 64 MiB of codes", "[generate]") {
    Recipe recipe = SmallRecipe().read();
    recipe.condition.frames = 4096;
    const ShardPlan plan = plan_shards(recipe);
    const std::size_t bytes = plan.sessions_per_shard * 4096 * recipe.codes_per_frame() * 2;
    CHECK(bytes <= std::size_t{64} << 20);
    CHECK(bytes > std::size_t{32} << 20);
}

TEST_CASE("the shares of a run have every shard once", "[generate]") {
    std::map<std::size_t, int> owners;
    for (std::size_t index = 0; index < 8; ++index)
        for (std::size_t shard = 0; shard < 30; ++shard)
            owners[shard] += Share{index, 8}.holds(shard);
    for (const auto& [shard, n] : owners) CHECK(n == 1);
}

TEST_CASE("a share is read from numbers, Slurm's array or OpenMPI", "[generate]") {
    CHECK(share("").is_whole());
    CHECK(share("3/8").index == 3);
    CHECK(share("3/8").count == 8);
    const Share slurm = share("env", {{"SLURM_ARRAY_TASK_ID", "14"},
                                      {"SLURM_ARRAY_TASK_MIN", "10"},
                                      {"SLURM_ARRAY_TASK_STEP", "2"},
                                      {"SLURM_ARRAY_TASK_COUNT", "4"}});
    CHECK(slurm.index == 2);
    CHECK(slurm.count == 4);
    const Share mpi = share("env", {{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "2"}});
    CHECK(mpi.index == 1);
    CHECK(mpi.count == 2);
}

TEST_CASE("a share that does not exist is refused with those that do", "[generate]") {
    const auto refusal = [](const std::string& text, const Variables& variables = {}) {
        return message_of([&] { return share(text, variables); });
    };
    CHECK(refusal("8/8") == "--shard 8/8: is none of the shares, which are 0/8 to 7/8");
    CHECK(refusal("0/0") ==
          "--shard 0/0: is a share of none; write INDEX/COUNT with a COUNT from 1, such as 0/8");
    CHECK(refusal("1/1") == "--shard 1/1: is none of the shares, which are 0/1 alone");
    for (const std::string text : {"3", "a/8", "3/", "-1/8", "1/8x", "1.5/8"}) {
        INFO(text);
        CHECK(refusal(text).find("such as 0/8, or env") != std::string::npos);
    }
    CHECK(refusal("env").find("start it with sbatch --array or mpirun") != std::string::npos);
    CHECK(refusal("env", {{"SLURM_ARRAY_TASK_ID", "3"}}).find("SLURM_ARRAY_TASK_COUNT") !=
          std::string::npos);
    CHECK(refusal("env", {{"SLURM_ARRAY_TASK_ID", "3"},
                          {"SLURM_ARRAY_TASK_MIN", "4"},
                          {"SLURM_ARRAY_TASK_COUNT", "2"}})
              .find("is not of the array") != std::string::npos);
}

}  // namespace
}  // namespace specula
