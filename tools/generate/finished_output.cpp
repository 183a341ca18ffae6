#include "tools/generate/finished_output.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>

#include "sim/core/error.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/sha256.hpp"
#include "tools/generate/generate.hpp"
#include "tools/generate/shard_folder.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t frames_at_once = 1 << 16;

template <typename Wanted>
void remove_files(const fs::path& folder, const Wanted& wanted) {
    std::error_code ignored;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (wanted(entry.path().filename().string())) files.push_back(entry.path());
    for (const fs::path& file : files) fs::remove(file, ignored);
}

bool begins_with(const std::string& text, const std::string& beginning) {
    return text.rfind(beginning, 0) == 0;
}

/// A draft `NAME.draft-PID-N` of a document that a killed process left; one of a living process is
/// still being written.
bool is_abandoned_document(const std::string& name) {
    for (const std::string document : {"DATASHEET.md", "croissant.json"}) {
        const std::string mark = document + ".draft-";
        if (!begins_with(name, mark)) continue;
        const int process = std::atoi(name.c_str() + mark.size());
        return process > 0 && ::kill(process, 0) == -1 && errno == ESRCH;
    }
    return false;
}

}  // namespace

FinishedOutput::FinishedOutput(const fs::path& out)
    : file_(is_folder_output(out) ? out / "index.h5" : out),
      shards_(is_folder_output(out) ? out : fs::path(out.string() + ".parts")),
      keeps_shards_(is_folder_output(out)) {}

bool FinishedOutput::is_there(const std::string& recipe) const {
    if (!fs::exists(file_) || (keeps_shards_ && !shards_are_whole())) return false;
    check_same_recipe(file_, DatasetReader(file_).form().origin.recipe, recipe);
    return true;
}

bool FinishedOutput::shards_are_whole() const {
    const ShardHashes told = read_manifests(shards_);
    for (const auto& [shard, hash] : told) {
        if (!fs::exists(shards_ / shard)) return false;
        if (sha256_of_file(shards_ / shard) != hash)
            throw InputError((shards_ / shard).string() +
                             ": is damaged, its SHA-256 is not the manifest's; remove it, and the "
                             "same command makes it again");
    }
    return !told.empty();
}

std::string FinishedOutput::fingerprint() const {
    const DatasetReader in(file_);
    Fingerprint all;
    for (std::size_t first = 0; first < in.n_frames(); first += frames_at_once)
        all.add(in.frame_hashes({first, std::min(first + frames_at_once, in.n_frames())}));
    return all.text();
}

double FinishedOutput::bytes() const {
    if (!keeps_shards_) return static_cast<double>(fs::file_size(file_));
    double bytes = 0.0;
    for (const auto& [shard, hash] : read_manifests(shards_))
        bytes += static_cast<double>(fs::file_size(shards_ / shard));
    return bytes;
}

void FinishedOutput::remove_drafts(const Share& share) const {
    if (!share.is_whole()) return;
    const fs::path folder = file_.has_parent_path() ? file_.parent_path() : fs::path(".");
    remove_files(folder, [&](const std::string& name) {
        return begins_with(name, file_.filename().string() + ".draft-");
    });
}

void FinishedOutput::remove_leftovers() const {
    std::error_code ignored;
    remove_files(file_.has_parent_path() ? file_.parent_path() : fs::path("."),
                 is_abandoned_document);
    if (!keeps_shards_) {
        fs::remove_all(shards_, ignored);
        return;
    }
    remove_files(shards_, [](const std::string& name) {
        return name == "lock" || begins_with(name, "lock-") || begins_with(name, "manifest-");
    });
}

}  // namespace specula
