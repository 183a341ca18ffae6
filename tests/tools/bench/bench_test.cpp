#include "tools/bench/bench.hpp"

#include <nlohmann/json.hpp>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/run_program.hpp"
#include "tools/bench/bench_figures.hpp"
#include "tools/bench/bench_text.hpp"
#include "tools/bench/stopwatch.hpp"

// Times are not looked at: they belong to the machine. That all is measured, and made of one piece,
// is.

namespace specula {
namespace {

BenchReport measured(std::vector<std::string> parts) {
    std::atomic<std::size_t> done{0};
    const BenchPlan plan{.parts = std::move(parts), .budget_s = 1e-4, .threads = 2};
    const BenchReport report = run_bench(plan, catalogue(), done);
    CHECK(done == bench_steps(plan));
    return report;
}

TEST_CASE("rates are positive, and held against limits that were measured", "[bench]") {
    const BenchReport report = measured({"receiver", "trace"});
    REQUIRE(report.rates.size() > 8);
    for (const BenchRate& rate : report.rates) {
        INFO(rate.part << ": " << rate.name);
        CHECK(rate.per_second > 0.0);
        CHECK(std::isfinite(rate.per_second));
        if (rate.limit.empty()) continue;
        const BenchRate* limit = report.find(rate.part, rate.limit);
        REQUIRE(limit != nullptr);
        CHECK(rate.share_of_limit == Approx(rate.per_second / limit->per_second));
    }
    CHECK(report.find("trace", "shadow rays, 2 triangles") != nullptr);
}

TEST_CASE("the sums that are timed are right", "[bench]") {
    for (const BenchRate& rate : measured({"channel"}).rates) {
        if (!rate.error) continue;
        INFO(rate.name);
        CHECK(*rate.error < 0.012);  // 0.1 dB
        CHECK_FALSE(rate.oracle.empty());
    }
}

TEST_CASE("JSON and tables hold what was measured", "[bench]") {
    BenchReport report;
    report.add({.part = "trace", .name = "limit", .unit = "rays", .per_second = 4e6});
    report.add({.part = "trace",
                .name = "ours",
                .unit = "rays",
                .per_second = 3e6,
                .limit = "limit",
                .error = 1e-5,
                .oracle = "other"});
    report.stages.push_back({.name = "beat", .microseconds = 2.5});
    report.growth.push_back({"frames", "frames", {{1.0, 0.5}, {100.0, 50.0}}});
    report.threads = {{1, 10.0, 0.1}, {2, 19.0, 0.11}};
    CHECK(report.rates[1].share_of_limit == 0.75);
    CHECK(report.growth[0].exponent() == Approx(1.0));
    const auto json = nlohmann::json::parse(bench_json(report, {}));
    CHECK(json["format"] == "specula-bench");
    CHECK(json["rates"][1]["share_of_limit"] == 0.75);
    CHECK_FALSE(json["rates"][0].contains("limit"));
    CHECK(json["growth"][0]["points"][1]["cpu_s"] == 50.0);
    CHECK(json["threads"][1]["threads"] == 2);
    const std::string text = bench_text(report);
    CHECK(text.find("3 M") != std::string::npos);
    CHECK(text.find("0.75 of limit") != std::string::npos);
    CHECK(text.find("1.90 times one") != std::string::npos);
    const auto figures = bench_figures(report);
    REQUIRE(figures.size() == 2);
    CHECK(figures[0].csv.find("beat,session,2.500") != std::string::npos);
    CHECK(figures[1].csv.find("frames,100,100,50") != std::string::npos);
}

TEST_CASE("time is that of the thread, and the fastest of several batches", "[bench]") {
    int calls = 0;
    const double seconds = seconds_per_call(0.01, [&] { ++calls; });
    CHECK(calls > 3);
    CHECK(seconds > 0.0);
    CHECK(seconds < 1e-3);
    CHECK(peak_memory_bytes() > 1e6);
}

TEST_CASE("bench is asked for by part, and says which there are", "[program][bench]") {
    const MadeUpFolder folder;
    const Ended wrong = specula_in(folder.path(), {"bench", "chanel"});
    CHECK(wrong.status == 2);
    CHECK(wrong.output.empty());
    CHECK(wrong.errors.find("did you mean channel?") != std::string::npos);
    const Ended ended =
        specula_in(folder.path(), {"bench", "receiver", "--seconds", "0.001", "--json"});
    CHECK(ended.status == 0);
    CHECK(nlohmann::json::parse(ended.output)["rates"].size() > 4);
}

}  // namespace
}  // namespace specula
