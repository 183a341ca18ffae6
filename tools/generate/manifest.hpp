#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace specula {

/// SHA-256 of finished shards by file name, in lines that `sha256sum -c` takes.
using ShardHashes = std::map<std::string, std::string>;

/// All `manifest*.sha256` of a folder. A last line that was cut short by a kill does not count.
/// Throws InputError for other damage, and where two of them tell different hashes of a shard.
ShardHashes read_manifests(const std::filesystem::path& folder);

/// Adds a line and brings it to the disk. Throws SystemError.
void append_to_manifest(const std::filesystem::path& manifest, const std::string& shard,
                        const std::string& hash);

/// The whole text of a manifest, ordered by name.
std::string manifest_text(const ShardHashes& hashes);

}  // namespace specula
