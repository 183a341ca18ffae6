#pragma once

#include <memory>

#include "tools/generate/manifest.hpp"
#include "sim/core/output_lock.hpp"
#include "tools/generate/shard_plan.hpp"

namespace specula {

/// A finished shard somewhere on disk.
struct FinishedShard {
    std::filesystem::path file;
    std::string hash;  ///< SHA-256 that its manifest tells
};

/// The folder that a process fills with shards, locked against others that would fill in the same.
/// Shards are immutable: each appears whole, on the disk, and is then named in the manifest.
class ShardFolder {
  public:
    /// Makes the folder; removes drafts that a killed process left; adds shards to the manifest
    /// that such a process had no time to name. Throws InputError where another process is at work
    /// or a shard is of another recipe, and tells what differs.
    ShardFolder(const std::filesystem::path& folder, const Recipe& recipe, const Share& share);

    const ShardPlan& plan() const { return plan_; }
    /// Shards of the share that are still to be made, in order.
    std::vector<std::size_t> missing() const;
    std::size_t n_finished() const { return hashes_.size(); }
    const std::filesystem::path& path() const { return folder_; }

    std::filesystem::path file_of(std::size_t shard) const { return folder_ / shard_name(shard); }
    /// Writes a shard from the frames of its sessions. Returns its size in bytes.
    std::size_t publish(std::size_t shard, const std::vector<FrameBlock>& sessions);
    /// All shards of the plan, which must be finished.
    std::vector<FinishedShard> all() const;

  private:
    void remove_drafts() const;
    void find_finished();
    std::filesystem::path manifest() const;

    std::filesystem::path folder_;
    const Recipe& recipe_;
    Share share_;
    ShardPlan plan_;
    std::unique_ptr<OutputLock> folder_lock_;
    std::unique_ptr<OutputLock> share_lock_;  ///< beside other shares
    ShardHashes hashes_;                      ///< of the shares' own and all other shards here
};

/// Throws InputError where the recipe of a file is another one: `file: was made otherwise: ...`.
void check_same_recipe(const std::filesystem::path& file, const std::string& there,
                       const std::string& here);

}  // namespace specula
