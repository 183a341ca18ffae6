#pragma once

#include "tools/generate/shard_plan.hpp"

namespace specula {

struct GenerateRequest {
    std::filesystem::path out;  ///< FILE.h5, or a folder: one that exists or whose name ends in /
    Share share{};
    int threads = 1;
    std::function<void(const std::string&)> say;  ///< one line before a long run; empty: silence
    /// What somebody is told who stops it.
    std::string on_stop = "stopped; what is finished is kept: run the same command again to resume";
};

struct GenerateReport {
    std::filesystem::path file;  ///< the finished dataset or index; empty: of a share's shards
    std::size_t n_frames = 0;    ///< of the whole run
    std::size_t n_recorded = 0;  ///< frames simulated by this call
    double bytes = 0.0;          ///< of the finished file, or of the shards of this call
    double seconds = 0.0;        ///< of this call, forecast and assembly included
    double peak_resident_bytes = 0.0;  ///< of the process so far
    std::string fingerprint;           ///< of all frames; empty: of a share's shards
    std::size_t n_shards = 0;          ///< of the whole run
    std::size_t n_shards_finished = 0;
    bool is_undocumented = false;  ///< a finished file was there, and no document told its SHA-256
};

/// Simulates a recipe's dataset into shards, taking up what an earlier call left, and makes one
/// file or an index of them. The same bytes for any number of threads, any shares, and any number
/// of interruptions. Memory holds two shards at most.
///
/// Throws InputError where the output is of another recipe or in another process's hands,
/// SystemError for what the system refuses, Interrupted for signals; what is finished stays.
GenerateReport run_generate(const Recipe& recipe, const GenerateRequest& request,
                            const Library& materials);

/// Whether an output names a folder of shards.
bool is_folder_output(const std::filesystem::path& out);
/// Most memory that the process ever had.
double peak_resident_bytes();

}  // namespace specula
