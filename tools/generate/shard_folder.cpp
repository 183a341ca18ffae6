#include "tools/generate/shard_folder.hpp"

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "tools/generate/record_session.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr const char* draft_mark = ".h5.draft-";

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw SystemError(folder.string() + ": cannot create: " + error.message());
}

DatasetReader opened(const fs::path& shard) {
    try {
        return DatasetReader(shard);
    } catch (const InputError& error) {
        throw InputError(
            format("{}; remove it, and the same command makes it again", error.what()));
    }
}

}  // namespace

void check_same_recipe(const fs::path& file, const std::string& there, const std::string& here) {
    const std::string difference = recipe_difference(there, here);
    if (!difference.empty())
        throw InputError(
            format("{}: was made otherwise: {}; give back the same settings, or name "
                   "another output",
                   file.string(), difference));
}

ShardFolder::ShardFolder(const fs::path& folder, const Recipe& recipe, const Share& share)
    : folder_(folder), recipe_(recipe), share_(share), plan_(plan_shards(recipe)) {
    make_folder(folder);
    const bool alone = share.is_whole();
    folder_lock_ = std::make_unique<OutputLock>(
        folder / "lock", alone ? OutputLock::Kind::alone : OutputLock::Kind::beside_others);
    if (!alone)
        share_lock_ = std::make_unique<OutputLock>(
            folder / format("lock-{}-of-{}", share.index, share.count), OutputLock::Kind::alone);
    remove_drafts();
    find_finished();
}

fs::path ShardFolder::manifest() const {
    return folder_ / (share_.is_whole()
                          ? std::string("manifest.sha256")
                          : format("manifest-{}-of-{}.sha256", share_.index, share_.count));
}

void ShardFolder::remove_drafts() const {
    std::vector<fs::path> drafts;
    for (const auto& entry : fs::directory_iterator(folder_)) {
        const std::string name = entry.path().filename().string();
        const auto mark = name.find(draft_mark);
        if (mark == std::string::npos) continue;
        for (std::size_t shard = share_.index; shard < plan_.n_shards(); shard += share_.count)
            if (shard_name(shard) == name.substr(0, mark) + ".h5") drafts.push_back(entry.path());
    }
    std::error_code ignored;
    for (const fs::path& draft : drafts) fs::remove(draft, ignored);
}

void ShardFolder::find_finished() {
    const ShardHashes told = read_manifests(folder_);
    for (std::size_t shard = 0; shard < plan_.n_shards(); ++shard) {
        if (!fs::exists(file_of(shard))) continue;
        const auto hash = told.find(shard_name(shard));
        if (!share_.holds(shard)) {
            if (hash != told.end()) hashes_.insert(*hash);
            continue;
        }
        const DatasetReader in = opened(file_of(shard));
        check_same_recipe(file_of(shard), in.form().origin.recipe, recipe_.text);
        if (in.shard() != plan_.span(shard))
            throw InputError(file_of(shard).string() +
                             ": holds other sessions than its number says; remove it");
        if (hash != told.end()) {
            hashes_.insert(*hash);
            continue;
        }
        hashes_[shard_name(shard)] = sha256_of_file(file_of(shard));
        append_to_manifest(manifest(), shard_name(shard), hashes_[shard_name(shard)]);
    }
}

std::vector<std::size_t> ShardFolder::missing() const {
    std::vector<std::size_t> shards;
    for (std::size_t shard = share_.index; shard < plan_.n_shards(); shard += share_.count)
        if (!hashes_.contains(shard_name(shard))) shards.push_back(shard);
    return shards;
}

std::size_t ShardFolder::publish(std::size_t shard, const std::vector<FrameBlock>& sessions) {
    const Dataset form = dataset_form(recipe_);
    std::size_t n_frames = 0;
    for (const FrameBlock& session : sessions) n_frames += session.n_frames();
    DatasetWriter out(file_of(shard), {.form = form,
                                       .tables = stored_tables(recipe_),
                                       .n_frames = n_frames,
                                       .shard = plan_.span(shard)});
    for (const FrameBlock& session : sessions) out.append(session);
    out.publish();
    const std::string hash = sha256_of_file(file_of(shard));
    append_to_manifest(manifest(), shard_name(shard), hash);
    hashes_[shard_name(shard)] = hash;
    return fs::file_size(file_of(shard));
}

std::vector<FinishedShard> ShardFolder::all() const {
    std::vector<FinishedShard> shards;
    for (std::size_t shard = 0; shard < plan_.n_shards(); ++shard)
        shards.push_back({file_of(shard), hashes_.at(shard_name(shard))});
    return shards;
}

}  // namespace specula
