#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace specula {

struct MergeRequest {
    std::vector<std::filesystem::path> folders;  ///< of shards
    std::filesystem::path out;                   ///< FILE.h5, or the one folder of all shards
};

struct MergeReport {
    std::filesystem::path file;
    std::size_t n_shards = 0;
    std::size_t n_frames = 0;
    double bytes = 0.0;
    std::string fingerprint;
};

/// Makes of the shards of one run, wherever they were made, the dataset that one process would have
/// made. Throws InputError for a shard without a hash or with other bytes than it tells, for gaps
/// and overlaps of sessions, and for shards of another seed, recipe or version, each by name.
MergeReport run_merge(const MergeRequest& request);

}  // namespace specula
