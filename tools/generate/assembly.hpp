#pragma once

#include "tools/generate/shard_folder.hpp"

namespace specula {

/// What an assembled dataset came to.
struct Assembled {
    std::size_t n_frames = 0;
    std::string fingerprint;
};

/// Copies shards, in the order of their sessions, into one file that appears whole. Each shard is
/// checked against its hash first; codes are copied as they are packed. Memory holds one shard.
/// Throws InputError naming a shard whose bytes are not those of its hash, and where a file of that
/// name is there by now.
Assembled assemble(const std::vector<FinishedShard>& shards, const std::filesystem::path& file);

/// Leaves the shards where they are, all in one folder, and writes index.h5 and the manifest beside
/// them. The same checks.
Assembled index_shards(const std::vector<FinishedShard>& shards,
                       const std::filesystem::path& folder);

}  // namespace specula
