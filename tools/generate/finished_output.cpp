#include "tools/generate/finished_output.hpp"

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/sha256.hpp"
#include "tools/dataset/dataset_check.hpp"
#include "tools/dataset/dataset_documents.hpp"
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

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// What `work` finds wrong with a file, and then what to do about it.
template <typename Work>
auto with_remedy(const char* remedy, const Work& work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError(format("{}; {}", error.what(), remedy));
    }
}

/// Reads what was written: all frames of a file; of an index, whose shards have a hash each, the first
/// and the last, which open every table of it.
void check_frames(const DatasetReader& in, bool is_index) {
    if (!is_index) return check_dataset(in);
    for (const std::size_t frame : {std::size_t{0}, in.n_frames() - 1})
        if (in.n_frames() > 0) in.read({frame, frame + 1});
}

}  // namespace

FinishedOutput::FinishedOutput(const fs::path& out)
    : file_(is_folder_output(out) ? out / "index.h5" : out),
      shards_(is_folder_output(out) ? out : fs::path(out.string() + ".parts")),
      keeps_shards_(is_folder_output(out)) {}

bool FinishedOutput::is_there(const std::string& recipe) const {
    place_of_file(file_);  // refuses what is no file
    if (!fs::exists(file_) || (keeps_shards_ && !shards_are_whole())) return false;
    const DatasetReader in = with_remedy(
        has_document() ? "remove it, and the same command makes it again"
                       : "name another output, or remove it if it is a damaged one of this command",
        [&] { return DatasetReader(file_); });
    check_same_recipe(file_, in.form().origin.recipe, recipe);
    check_document();
    with_remedy("remove it, and the same command makes it again",
                [&] { check_frames(in, keeps_shards_); });
    return true;
}

bool FinishedOutput::has_document() const {
    return !documented_hash(file_).empty();
}

void FinishedOutput::check_document() const {
    const std::string told = documented_hash(file_);
    if (told.empty() || told == sha256_of_file(file_)) return;
    throw InputError(format(
        "{}: is damaged: its SHA-256 is not the one that {} tells; remove it, and the same command "
        "makes it again",
        file_.string(), document_files(file_, "").croissant.string()));
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
    std::vector<fs::path> made{place_of_file(file_)};
    if (keeps_shards_) made.push_back(shards_ / "manifest.sha256");
    for (const fs::path& each : made)
        remove_files(folder_of(each), [&](const std::string& name) {
            return begins_with(name, each.filename().string() + ".draft-");
        });
}

void FinishedOutput::remove_leftovers() const {
    std::error_code ignored;
    if (!keeps_shards_) {
        fs::remove_all(shards_, ignored);
        return;
    }
    remove_files(shards_, [](const std::string& name) {
        return name == "lock" || begins_with(name, "lock-") || begins_with(name, "manifest-");
    });
}

}  // namespace specula
