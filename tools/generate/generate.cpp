#include "tools/generate/generate.hpp"

#include <sys/resource.h>

#include <chrono>
#include <future>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/parallel.hpp"
#include "tools/generate/assembly.hpp"
#include "tools/generate/finished_output.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/generate/new_folders.hpp"
#include "tools/generate/preflight.hpp"
#include "tools/generate/record_session.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

/// Simulates shard after shard; while one is simulated, the one before goes to the disk.
class ShardRecorder {
  public:
    ShardRecorder(const Recipe& recipe, const Library& materials, ShardFolder& folder,
                  Progress& progress)
        : recipe_(recipe), materials_(materials), folder_(folder), progress_(progress) {}

    void record(std::size_t shard, int threads) {
        const SessionSpan span = folder_.plan().span(shard);
        std::vector<FrameBlock> sessions(span.count);
        for_each_index(span.count, threads, [&](std::size_t i) {
            InterruptionWatch::check();
            sessions[i] = record_session(recipe_, materials_, span.first + i);
            progress_.done() += sessions[i].n_frames();
        });
        finish();
        writing_ = std::async(std::launch::async, [this, shard, done = std::move(sessions)] {
            const std::size_t bytes = folder_.publish(shard, done);
            progress_.bytes() += bytes;
        });
    }
    /// Waits for the shard that is being written, and throws what went wrong with it.
    void finish() {
        if (writing_.valid()) writing_.get();
    }

    /// Waits for it, whatever comes of it.
    void wait() {
        if (writing_.valid()) writing_.wait();
    }

  private:
    const Recipe& recipe_;
    const Library& materials_;
    ShardFolder& folder_;
    Progress& progress_;
    std::future<void> writing_;
};

std::size_t frames_of(const Recipe& recipe, const ShardPlan& plan,
                      const std::vector<std::size_t>& shards) {
    std::size_t sessions = 0;
    for (const std::size_t shard : shards) sessions += plan.span(shard).count;
    return sessions * static_cast<std::size_t>(recipe.condition.frames);
}

/// Says what a run will take, and refuses one that cannot fit.
void look_ahead(const Recipe& recipe, const GenerateRequest& request, const Library& materials,
                const ShardFolder& folder) {
    const auto missing = folder.missing();
    const auto n_missing = static_cast<double>(frames_of(recipe, folder.plan(), missing));
    const auto n_all = static_cast<double>(recipe.n_frames());
    const Forecast one = forecast(recipe, materials);
    const bool assembles = request.share.is_whole() && !is_folder_output(request.out);
    const double needed = one.bytes_per_frame * (n_missing + (assembles ? n_all : 0.0));
    if (request.say)
        request.say(
            format("{:.0f} frames in {} shards{}: about {}, {} on {} threads; {} free", n_missing,
                   missing.size(),
                   folder.n_finished() > 0 ? format(" ({} are finished)", folder.n_finished()) : "",
                   bytes_text(one.bytes_per_frame * n_missing),
                   seconds_text(one.seconds_per_frame * n_missing / request.threads),
                   request.threads, bytes_text(free_bytes(folder.path()))));
    check_space(folder.path(), needed);
}

void record_missing(const Recipe& recipe, const GenerateRequest& request, const Library& materials,
                    ShardFolder& folder) {
    const auto missing = folder.missing();
    Progress progress("Generating", "frames", frames_of(recipe, folder.plan(), missing));
    ShardRecorder recorder(recipe, materials, folder, progress);
    try {
        for (const std::size_t shard : missing) recorder.record(shard, request.threads);
        recorder.finish();
    } catch (const SystemError& error) {
        recorder.wait();
        throw SystemError(
            format("{}; {} of {} shards are finished and kept: mend it, and run the "
                   "same command again to resume",
                   error.what(), folder.n_finished(), folder.plan().n_shards()));
    }
}

/// Names files that look like shards of the run and are none.
void warn_of_strays(const GenerateRequest& request, const ShardPlan& plan) {
    const fs::path folder = FinishedOutput(request.out).shards();
    for (const fs::path& file : stray_shards(folder, plan))
        if (request.say)
            request.say(
                format("{}: is no part of this run and is passed over; remove it", file.string()));
}

/// The finished file: from its shards, which it takes the place of.
void finish_output(const GenerateRequest& request, ShardFolder& folder, GenerateReport& report) {
    const bool keeps_shards = is_folder_output(request.out);
    const Assembled made = keeps_shards ? index_shards(folder.all(), request.out)
                                        : assemble(folder.all(), request.out);
    report.fingerprint = made.fingerprint;
    report.file = keeps_shards ? request.out / "index.h5" : request.out;
    if (keeps_shards)
        for (const FinishedShard& shard : folder.all())
            report.bytes += static_cast<double>(fs::file_size(shard.file));
    else
        report.bytes = static_cast<double>(fs::file_size(request.out));
}

}  // namespace

bool is_folder_output(const fs::path& out) {
    return !out.has_filename() || fs::is_directory(out);
}

double peak_resident_bytes() {
    rusage usage = {};
    ::getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

GenerateReport run_generate(const Recipe& recipe, const GenerateRequest& request,
                            const Library& materials) {
    const auto start = std::chrono::steady_clock::now();
    GenerateReport report;
    report.n_frames = recipe.n_frames();
    report.n_shards = report.n_shards_finished = plan_shards(recipe).n_shards();
    const FinishedOutput output(request.out);
    if (output.is_there(recipe.text)) {
        report.file = output.file();
        report.fingerprint = output.fingerprint();
        report.bytes = output.bytes();
        report.is_undocumented = !output.has_document();
        if (is_folder_output(request.out)) warn_of_strays(request, plan_shards(recipe));
        output.remove_leftovers();
    } else {
        const InterruptionWatch watch(request.on_stop);
        const NewFolders made(output.shards());
        ShardFolder folder(output.shards(), recipe, request.share);
        output.remove_drafts(request.share);
        warn_of_strays(request, folder.plan());
        const auto missing = folder.missing();
        if (!missing.empty()) {
            try {
                look_ahead(recipe, request, materials, folder);
            } catch (...) {
                if (folder.n_finished() == 0) {
                    output.remove_leftovers();
                    made.remove_empty();
                }
                throw;
            }
            record_missing(recipe, request, materials, folder);
            report.n_recorded = frames_of(recipe, folder.plan(), missing);
        }
        report.n_shards_finished = folder.n_finished();
        if (request.share.is_whole()) {
            finish_output(request, folder, report);
            output.remove_leftovers();
        }
    }
    report.peak_resident_bytes = peak_resident_bytes();
    report.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace specula
