#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "scenes/catalogue.hpp"

namespace specula {

/// One measured rate, of one core.
struct BenchRate {
    std::string part{};             ///< "trace", "channel", ...
    std::string name{};             ///< what was done
    std::string unit{};             ///< what is counted
    double per_second = 0.0;        ///< CPU-second of one core
    std::string limit{};            ///< name of the rate of the same part it is held against
    double share_of_limit = 0.0;    ///< of that rate; 0: held against none
    std::optional<double> error{};  ///< against the oracle, of its largest value
    std::string oracle{};           ///< what that was
};

/// What one frame costs in a stage.
struct BenchStage {
    std::string name;
    double microseconds = 0.0;  ///< CPU time per session, or per frame
    bool per_frame = false;
};

/// How a cost grows.
struct BenchGrowth {
    std::string name;  ///< of the stage
    std::string axis;  ///< what was made larger
    struct Point {
        double size;
        double seconds;  ///< CPU time of one call
    };
    std::vector<Point> points;
    /// Of the power law nearest to all points, by their logarithms: 1 is linear, less is better.
    double exponent() const;
};

/// What several threads do at once.
struct BenchThreads {
    int threads = 1;
    double per_second = 0.0;      ///< sessions, by the clock on the wall
    double cpu_s_per_item = 0.0;  ///< grows where threads wait for each other
};

/// A whole dataset, from laws to a compressed file.
struct BenchGenerated {
    double frames = 0.0;
    int threads = 1;
    double frames_per_s = 0.0;  ///< by the clock on the wall
    double bytes_per_s = 0.0;   ///< of the file
    double peak_memory_bytes = 0.0;
};

struct BenchReport {
    std::vector<BenchGenerated> generated;
    std::vector<BenchRate> rates;
    std::vector<BenchStage> stages;
    std::vector<BenchGrowth> growth;
    std::vector<BenchThreads> threads;

    const BenchRate* find(const std::string& part, const std::string& name) const;
    /// Adds a rate; held against another one of its part where `limit` names it.
    void add(BenchRate rate);
};

/// What to measure, and how long.
struct BenchPlan {
    std::vector<std::string> parts;  ///< of bench_parts(); empty: all
    double budget_s = 0.3;           ///< per rate
    int threads = 1;                 ///< the most that are tried
    double growth_decades = 3.0;     ///< of every axis
};

/// The parts in the order in which they run.
std::vector<std::string> bench_parts();

/// How many steps run() will count.
std::size_t bench_steps(const BenchPlan& plan);

/// Measures ours and its limits one after the other, in this process.
/// Throws InputError for a part that does not exist.
BenchReport run_bench(const BenchPlan& plan, const Catalogue& catalogue,
                      std::atomic<std::size_t>& done);

}  // namespace specula
