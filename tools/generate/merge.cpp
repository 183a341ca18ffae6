#include "tools/generate/merge.hpp"

#include <algorithm>

#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "tools/generate/assembly.hpp"
#include "tools/generate/generate.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/generate/new_folders.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

struct Part {
    FinishedShard shard;
    SessionSpan span;
};

/// How the run was parted, as far as its shards tell.
ShardPlan plan_of(const std::vector<Part>& parts) {
    ShardPlan plan;
    for (const Part& part : parts) {
        plan.n_sessions = std::max(plan.n_sessions, part.span.n_in_all);
        plan.sessions_per_shard = std::max(plan.sessions_per_shard, part.span.count);
    }
    return plan;
}

/// Refuses a file of which no manifest knows: a shard of the run by its name, or none.
[[noreturn]] void fail_unlisted(const fs::path& file, const std::vector<Part>& parts) {
    const auto strays = stray_shards(file.parent_path(), plan_of(parts));
    const bool is_stray =
        !parts.empty() && std::find(strays.begin(), strays.end(), file) != strays.end();
    throw InputError(file.string() +
                     (is_stray ? ": is no part of this run: remove it"
                               : ": no manifest tells its hash; run its generate command again"));
}

void add_parts(const fs::path& folder, std::vector<Part>& parts, std::vector<fs::path>& unlisted) {
    if (!fs::is_directory(folder))
        throw InputError(folder.string() +
                         ": no such folder; name the folders that "
                         "specula generate --shard wrote");
    const ShardHashes hashes = read_manifests(folder);
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (!is_shard(entry.path())) continue;
        const auto hash = hashes.find(entry.path().filename().string());
        if (hash == hashes.end()) {
            unlisted.push_back(entry.path());
            continue;
        }
        const DatasetReader in(entry.path());
        if (!in.shard())
            throw InputError(entry.path().string() +
                             ": does not say which sessions it holds; "
                             "name folders of shards");
        parts.push_back({{entry.path(), hash->second}, *in.shard()});
    }
    for (const auto& [shard, hash] : hashes)
        if (!fs::exists(folder / shard))
            throw InputError((folder / shard).string() +
                             ": is in the manifest, but not there; run "
                             "its generate command again");
}

std::string sessions_text(std::size_t first, std::size_t end) {
    return format("sessions {} to {}", first, end - 1);
}

/// Refuses what is not the same run as the first shard.
void check_one_run(const std::vector<Part>& parts) {
    const Part& first = parts.front();
    const std::string recipe = DatasetReader(first.shard.file).form().origin.recipe;
    for (const Part& part : parts) {
        const std::string difference =
            recipe_difference(recipe, DatasetReader(part.shard.file).form().origin.recipe);
        if (!difference.empty())
            throw InputError(format("{}: is of another run than {}: {}; leave it out",
                                    part.shard.file.string(), first.shard.file.string(),
                                    difference));
        if (part.span.n_in_all != first.span.n_in_all)
            throw InputError(format("{}: is of a run of {} sessions, {} of one of {}",
                                    part.shard.file.string(), part.span.n_in_all,
                                    first.shard.file.string(), first.span.n_in_all));
    }
}

/// Refuses gaps and overlaps; parts in the order of their sessions.
void check_tiling(const std::vector<Part>& parts) {
    std::size_t end = 0;
    const fs::path* before = nullptr;
    std::string gaps;
    const auto gap = [&](std::size_t from, std::size_t to) {
        gaps += (gaps.empty() ? "" : ", ") + sessions_text(from, to);
    };
    for (const Part& part : parts) {
        if (part.span.first < end)
            throw InputError(format("{}: holds {} a second time, beside {}; remove one of them",
                                    part.shard.file.string(),
                                    sessions_text(part.span.first, std::min(end, part.span.end())),
                                    before->string()));
        if (part.span.first > end) gap(end, part.span.first);
        end = part.span.end();
        before = &part.shard.file;
    }
    const std::size_t all = parts.front().span.n_in_all;
    if (end < all) gap(end, all);
    if (!gaps.empty())
        throw InputError(
            format("{} of {} are missing; run the generate commands that make them", gaps, all));
}

}  // namespace

MergeReport run_merge(const MergeRequest& request) {
    std::vector<Part> parts;
    std::vector<fs::path> unlisted;
    for (const fs::path& folder : request.folders) add_parts(folder, parts, unlisted);
    if (!unlisted.empty())
        fail_unlisted(*std::min_element(unlisted.begin(), unlisted.end()), parts);
    if (parts.empty())
        throw InputError(request.folders.front().string() +
                         ": holds no shards; name the folders that specula generate --shard wrote");
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.span.first < b.span.first; });
    check_one_run(parts);
    check_tiling(parts);
    const bool keeps_shards = is_folder_output(request.out);
    const fs::path file = keeps_shards ? request.out / "index.h5" : request.out;
    place_of_file(file);  // refuses what is no file
    if (keeps_shards &&
        (request.folders.size() > 1 || !fs::equivalent(request.folders.front(), request.out)))
        throw InputError(request.out.string() +
                         ": is not the folder that the shards are in, where "
                         "they stay; name that one, or a FILE.h5");
    if (!keeps_shards && fs::exists(request.out))
        throw InputError(request.out.string() + ": is there already; name another file");

    std::vector<FinishedShard> shards;
    for (const Part& part : parts) shards.push_back(part.shard);
    const InterruptionWatch watch(
        "stopped; nothing was written, the shards are as they were: run the same command again");
    remove_abandoned_drafts(file);
    if (keeps_shards) remove_abandoned_drafts(request.out / "manifest.sha256");
    const Assembled made = with_folders_of(file, [&] {
        return keeps_shards ? index_shards(shards, request.out) : assemble(shards, request.out);
    });
    MergeReport report{.file = file,
                       .n_shards = shards.size(),
                       .n_frames = made.n_frames,
                       .bytes = 0.0,
                       .fingerprint = made.fingerprint};
    if (!keeps_shards) report.bytes = static_cast<double>(fs::file_size(request.out));
    for (const FinishedShard& shard : shards)
        if (keeps_shards) report.bytes += static_cast<double>(fs::file_size(shard.file));
    return report;
}

}  // namespace specula
