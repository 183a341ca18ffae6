#pragma once

#include "tools/bench/bench.hpp"
#include "tools/bench/bench_scene.hpp"

namespace specula {

/// Each measures one part and adds to the report.
using BenchPart = void (*)(const BenchPlan&, const BenchScene&, BenchReport&);

void bench_generate(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_stages(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_trace(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_channel(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_receiver(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_frames(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_storage(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_learning(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_growth(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);
void bench_threads(const BenchPlan& plan, const BenchScene& scene, BenchReport& report);

}  // namespace specula
