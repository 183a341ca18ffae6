#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/dataset/dataset_writer.hpp"
#include "tools/generate/recipe.hpp"

namespace specula {

/// How a run's sessions are parted into shards. Depends on the recipe alone, so that any machine,
/// any number of threads and any `--shard` part them alike.
struct ShardPlan {
    std::size_t n_sessions = 0;
    std::size_t sessions_per_shard = 1;

    std::size_t n_shards() const {
        return (n_sessions + sessions_per_shard - 1) / sessions_per_shard;
    }
    SessionSpan span(std::size_t shard) const;
};

/// At most 64 MiB of codes per shard, and else no more shards than about a thousand.
ShardPlan plan_shards(const Recipe& recipe);

/// "shard-000012.h5".
std::string shard_name(std::size_t shard);
/// Whether a file looks like a shard: shard-*.h5.
bool is_shard(const std::filesystem::path& file);

/// Files of a folder, there or not, that look like shards and whose name none of the plan has, in
/// the order of their names.
std::vector<std::filesystem::path> stray_shards(const std::filesystem::path& folder,
                                                const ShardPlan& plan);

/// Which shards a process makes: those whose number leaves `index` when divided by `count`.
struct Share {
    std::size_t index = 0;
    std::size_t count = 1;

    bool is_whole() const { return count == 1; }
    bool holds(std::size_t shard) const { return shard % count == index; }
};

/// "3/8" (the fourth of eight), or "env": as Slurm's array or OpenMPI's launcher tell a process.
/// @in variable  looks up an environment variable; empty where there is none
/// Throws InputError that says what would do.
Share read_share(const std::string& text,
                 const std::function<std::string(const std::string&)>& variable);

}  // namespace specula
