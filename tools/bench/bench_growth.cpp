#include <cmath>

#include "sim/parallel.hpp"
#include "sim/simulate.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace {

/// One call at a size: returns what is to be timed.
using AtSize = std::function<std::function<void()>(double size)>;

/// Sizes in steps of half a decade.
BenchGrowth grown(const BenchPlan& plan, BenchGrowth growth, double first, const AtSize& at_size) {
    const int steps = std::max(1, static_cast<int>(2.0 * plan.growth_decades));
    for (int step = 0; step <= steps; ++step) {
        const double size = std::round(first * std::pow(10.0, 0.5 * step));
        const std::function<void()> work = at_size(size);
        const double seconds = seconds_per_call(0.3 * plan.budget_s, work);
        growth.points.push_back({size, seconds});
    }
    return growth;
}

/// The experiment's chirp, sampled more or less densely over the same band.
Radar with_samples(Radar radar, int n) {
    const double factor = n / static_cast<double>(radar.chirp.n_samples);
    radar.chirp.n_samples = n;
    radar.chirp.sample_rate_hz *= factor;
    radar.chirp.skip_samples = static_cast<int>(radar.chirp.skip_samples * factor);
    radar.chirp.filter_latency_samples = 0;
    return radar;
}

Radar with_rx(Radar radar, int n) {
    constexpr double pitch_m = 0.1e-3;  // so that a thousand stay within a hand
    const ReceiveChannel first = radar.rx.front();
    radar.rx.assign(static_cast<std::size_t>(n), first);
    for (std::size_t i = 0; i < radar.rx.size(); ++i)
        radar.rx[i].position_m.x() += pitch_m * static_cast<double>(i);
    radar.leakage.clear();
    return radar;
}

void frame_of(const Scene& scene, const Library& materials) {
    Stream noise({.seed = 1, .purpose = "bench growth"});
    simulate(scene, materials, noise);
}

}  // namespace

void bench_growth(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    constexpr double tilt_rad = 0.09;
    const Library& materials = scene.catalogue.materials;
    const Scene plate = scene.plate("plexiglass", tilt_rad);
    const auto add = [&](const char* axis, double first, const AtSize& at_size) {
        report.growth.push_back(grown(plan, {axis, axis, {}}, first, at_size));
    };
    add("area of the plate (cm2)", 10.0, [&](double size) {
        Scene grown_plate = plate;
        grown_plate.sample.face.size_x_m = grown_plate.sample.face.size_y_m =
            0.01 * std::sqrt(size);
        return [=, &materials] { frame_of(grown_plate, materials); };
    });
    add("samples per chirp", 16.0, [&](double size) {
        Scene sampled = plate;
        sampled.radar = with_samples(plate.radar, static_cast<int>(size));
        return [=, &materials] { frame_of(sampled, materials); };
    });
    add("receivers", 1.0, [&](double size) {
        Scene many = plate;
        many.radar = with_rx(plate.radar, static_cast<int>(size));
        return [=, &materials] { frame_of(many, materials); };
    });
    add("frames per session", 4.0, [&](double size) {
        Condition condition = scene.experiment.training;
        condition.frames = static_cast<int>(size);
        return [=, &scene] {
            simulate_session(scene.sessions(), condition, {.world = 0, .label = 2, .session = 0});
        };
    });
    add("triangles", 100.0, [&](double size) {
        const auto n = static_cast<std::uint32_t>(std::sqrt(0.5 * size));
        Scene ball = plate;
        ball.sample.mesh = std::make_shared<Mesh>(sphere_mesh({.distance_m = 0.0, .n_around = n}));
        return [=, &materials] { frame_of(ball, materials); };
    });
}

void bench_threads(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    const Bench bench = scene.sessions();
    Condition condition = scene.experiment.training;
    condition.sessions = Condition::most_sessions;
    const auto n_classes = bench.population.classes.size();
    const auto run = [&](std::size_t n, int threads) {
        for_each_index(n, threads, [&](std::size_t i) {
            simulate_session(bench, condition,
                             {.world = 0,
                              .label = static_cast<int>(i % n_classes),
                              .session = static_cast<int>(i / n_classes)});
        });
    };
    run(n_classes, plan.threads);  // starts the threads
    const double begin_s = wall_seconds();
    run(n_classes, 1);
    const double per_round_s = wall_seconds() - begin_s;
    const auto rounds = static_cast<std::size_t>(std::ceil(plan.budget_s / per_round_s));
    const std::size_t n = n_classes * std::clamp<std::size_t>(rounds, 1, 200);
    for (int threads = 1; threads <= plan.threads; threads *= 2) {
        const double from_s = wall_seconds(), cpu_from_s = process_seconds();
        run(n, threads);
        const auto items = static_cast<double>(n);
        report.threads.push_back({.threads = threads,
                                  .per_second = items / (wall_seconds() - from_s),
                                  .cpu_s_per_item = (process_seconds() - cpu_from_s) / items});
    }
}

}  // namespace specula
