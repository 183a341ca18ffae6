#include "tools/bench/bench.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/document.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/bench/parts.hpp"

namespace specula {

namespace {

const std::vector<std::pair<std::string, BenchPart>> all_parts{
    // First, so that the memory is its own.
    {"generate", bench_generate}, {"stages", bench_stages},     {"trace", bench_trace},
    {"channel", bench_channel},   {"receiver", bench_receiver}, {"frames", bench_frames},
    {"storage", bench_storage},   {"learning", bench_learning}, {"growth", bench_growth},
    {"threads", bench_threads}};

bool is_wanted(const BenchPlan& plan, const std::string& part) {
    return plan.parts.empty() ||
           std::find(plan.parts.begin(), plan.parts.end(), part) != plan.parts.end();
}

}  // namespace

double BenchGrowth::exponent() const {
    const auto n = static_cast<double>(points.size());
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Point& point : points) {
        const double log_size = std::log(point.size), log_s = std::log(point.seconds);
        x += log_size;
        y += log_s;
        xx += log_size * log_size;
        xy += log_size * log_s;
    }
    const double spread = n * xx - x * x;
    return spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
}

const BenchRate* BenchReport::find(const std::string& part, const std::string& name) const {
    for (const BenchRate& rate : rates)
        if (rate.part == part && rate.name == name) return &rate;
    return nullptr;
}

void BenchReport::add(BenchRate rate) {
    if (!rate.limit.empty())
        if (const BenchRate* limit = find(rate.part, rate.limit))
            rate.share_of_limit = rate.per_second / limit->per_second;
    rates.push_back(std::move(rate));
}

std::vector<std::string> bench_parts() {
    std::vector<std::string> names;
    for (const auto& [name, part] : all_parts) names.push_back(name);
    return names;
}

std::size_t bench_steps(const BenchPlan& plan) {
    return static_cast<std::size_t>(std::ranges::count_if(
        all_parts, [&](const auto& part) { return is_wanted(plan, part.first); }));
}

BenchReport run_bench(const BenchPlan& plan, const Catalogue& catalogue,
                      std::atomic<std::size_t>& done) {
    const std::vector<std::string> known = bench_parts();
    for (const std::string& part : plan.parts) {
        if (std::find(known.begin(), known.end(), part) != known.end()) continue;
        const std::string near = nearest_word(part, known);
        throw InputError(format("\"{}\": nothing to measure has that name; {}use {}", part,
                                near.empty() ? "" : "did you mean " + near + "? ",
                                quoted_list(known)));
    }
    const BenchScene scene(catalogue);
    BenchReport report;
    for (const auto& [name, measure] : all_parts) {
        if (!is_wanted(plan, name)) continue;
        measure(plan, scene, report);
        ++done;
    }
    return report;
}

}  // namespace specula
