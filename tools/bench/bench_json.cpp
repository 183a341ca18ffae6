#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/version.hpp"
#include "tools/bench/bench_text.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace {

using Ordered = nlohmann::ordered_json;

std::int64_t whole(double count) {
    return static_cast<std::int64_t>(std::llround(count));
}

Ordered rate_json(const BenchRate& rate) {
    Ordered json{{"part", rate.part},
                 {"name", rate.name},
                 {"unit", rate.unit},
                 {"per_cpu_second", rate.per_second}};
    if (rate.share_of_limit > 0.0) {
        json["limit"] = rate.limit;
        json["share_of_limit"] = rate.share_of_limit;
    }
    if (rate.error) {
        json["error"] = *rate.error;
        json["oracle"] = rate.oracle;
    }
    return json;
}

Ordered growth_json(const BenchGrowth& growth) {
    Ordered points = Ordered::array();
    for (const BenchGrowth::Point& point : growth.points)
        points.push_back({{"size", point.size}, {"cpu_s", point.seconds}});
    return {{"axis", growth.axis}, {"exponent", growth.exponent()}, {"points", points}};
}

}  // namespace

std::string bench_json(const BenchReport& report, const BenchPlan& plan) {
    Ordered json{{"format", "specula-bench"},
                 {"format_version", 1},
                 {"software_version", program_version},
                 {"seconds_per_rate", plan.budget_s},
                 {"peak_memory_bytes", whole(peak_memory_bytes())},
                 {"generated", Ordered::array()},
                 {"stages", Ordered::array()},
                 {"rates", Ordered::array()},
                 {"growth", Ordered::array()},
                 {"threads", Ordered::array()}};
    for (const BenchGenerated& made : report.generated)
        json["generated"].push_back({{"frames", whole(made.frames)},
                                     {"threads", made.threads},
                                     {"frames_per_wall_second", made.frames_per_s},
                                     {"bytes_per_wall_second", made.bytes_per_s},
                                     {"peak_memory_bytes", whole(made.peak_memory_bytes)}});
    for (const BenchStage& stage : report.stages)
        json["stages"].push_back({{"name", stage.name},
                                  {"cpu_us", stage.microseconds},
                                  {"per", stage.per_frame ? "frame" : "session"}});
    for (const BenchRate& rate : report.rates) json["rates"].push_back(rate_json(rate));
    for (const BenchGrowth& growth : report.growth) json["growth"].push_back(growth_json(growth));
    for (const BenchThreads& at : report.threads)
        json["threads"].push_back({{"threads", at.threads},
                                   {"sessions_per_wall_second", at.per_second},
                                   {"cpu_s_per_session", at.cpu_s_per_item}});
    return json.dump(1) + "\n";
}

}  // namespace specula
