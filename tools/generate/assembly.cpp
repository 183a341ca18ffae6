#include "tools/generate/assembly.hpp"

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/hdf5_index.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

void check_hash(const FinishedShard& shard) {
    if (sha256_of_file(shard.file) != shard.hash)
        throw InputError(
            format("{}: its bytes are not those of its manifest's SHA-256; remove it "
                   "and run its generate command again",
                   shard.file.string()));
}

std::size_t frames_in(const std::vector<FinishedShard>& shards) {
    std::size_t n = 0;
    for (const FinishedShard& shard : shards) n += DatasetReader(shard.file).n_frames();
    return n;
}

}  // namespace

Assembled assemble(const std::vector<FinishedShard>& shards, const fs::path& file) {
    SPECULA_EXPECT(!shards.empty());
    const std::size_t n_frames = frames_in(shards);
    const DatasetReader first(shards.front().file);
    DatasetWriter out(
        file, {.form = first.form(), .tables = first.tables(), .n_frames = n_frames, .shard = {}});
    Progress progress("Assembling", "frames", n_frames);
    for (const FinishedShard& shard : shards) {
        InterruptionWatch::check();
        check_hash(shard);
        const DatasetReader in(shard.file);
        out.append(in.read_packed({0, in.n_frames()}));
        progress.done() += in.n_frames();
    }
    return {n_frames, out.publish_new()};
}

Assembled index_shards(const std::vector<FinishedShard>& shards, const fs::path& folder) {
    Fingerprint all;
    ShardHashes hashes;
    std::vector<IndexedFile> files;
    std::size_t n_frames = 0;
    Progress progress("Indexing", "frames", frames_in(shards));
    for (const FinishedShard& shard : shards) {
        InterruptionWatch::check();
        check_hash(shard);
        const DatasetReader in(shard.file);
        all.add(in.frame_hashes({0, in.n_frames()}));
        hashes[shard.file.filename().string()] = shard.hash;
        files.push_back({shard.file.filename().string(), in.n_frames()});
        n_frames += in.n_frames();
        progress.done() = n_frames;
    }
    write_file_atomically(folder / "manifest.sha256", manifest_text(hashes));
    write_hdf5_index(folder / "index.h5", files);
    return {n_frames, all.text()};
}

}  // namespace specula
