#include "tools/bench/bench_text.hpp"

#include <cmath>

#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Three digits and a prefix: 1.23 M.
std::string short_number(double value) {
    for (const auto& [factor, prefix] : {std::pair{1e9, "G"}, {1e6, "M"}, {1e3, "k"}})
        if (value >= 0.9995 * factor) return format("{:.3g} {}", value / factor, prefix);
    return format("{:.3g} ", value);
}

std::string rates_text(const BenchReport& report) {
    std::string text, part;
    for (const BenchRate& rate : report.rates) {
        if (rate.part != part) text += format("\n{}, per second of one core\n", rate.part);
        part = rate.part;
        text += format("  {:<42} {:>9}{:<14}", rate.name, short_number(rate.per_second), rate.unit);
        if (rate.share_of_limit > 0.0)
            text += format("  {:.3g} of {}", rate.share_of_limit, rate.limit);
        if (rate.error) text += format("  error {:.1e}", *rate.error);
        while (text.back() == ' ') text.pop_back();
        text += "\n";
    }
    return text;
}

std::string stages_text(const BenchReport& report) {
    if (report.stages.empty()) return "";
    std::string text = "\nstages of the paper's experiment, CPU time, mean over its classes\n";
    for (const BenchStage& stage : report.stages)
        text += format("  {:<42} {:>9.1f} us per {}\n", stage.name, stage.microseconds,
                       stage.per_frame ? "frame" : "session");
    return text;
}

std::string growth_text(const BenchReport& report) {
    std::string text;
    if (!report.growth.empty())
        text += "\ngrowth: CPU time of a frame, or of a session of frames\n";
    for (const BenchGrowth& growth : report.growth) {
        text += format("  {:<26} time ~ size^{:.2f}:", growth.axis, growth.exponent());
        for (const BenchGrowth::Point& point : growth.points)
            text += format("  {:g}: {:.3g} ms", point.size, 1e3 * point.seconds);
        text += "\n";
    }
    return text;
}

std::string generated_text(const BenchReport& report) {
    std::string text;
    if (!report.generated.empty()) text += "\ngenerate: laws to a compressed file, by the clock\n";
    for (const BenchGenerated& made : report.generated)
        text += format("  {:>8.0f} frames, {} threads: {}frames/s, {}B/s, peak memory {}B\n",
                       made.frames, made.threads, short_number(made.frames_per_s),
                       short_number(made.bytes_per_s), short_number(made.peak_memory_bytes));
    return text;
}

std::string threads_text(const BenchReport& report) {
    std::string text;
    if (!report.threads.empty()) text += "\nthreads\n";
    for (const BenchThreads& at : report.threads)
        text += format(
            "  {:>3}: {:.1f} sessions/s by the clock, {:.2f} times one, CPU {:.3g} ms each\n",
            at.threads, at.per_second, at.per_second / report.threads.front().per_second,
            1e3 * at.cpu_s_per_item);
    return text;
}

}  // namespace

std::string bench_text(const BenchReport& report) {
    const std::string text = generated_text(report) + stages_text(report) + rates_text(report) +
                             growth_text(report) + threads_text(report);
    return text.empty() ? text : text.substr(1);
}

}  // namespace specula
