#include <cstring>

#include "sim/core/random.hpp"
#include "sim/simulate.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace {

constexpr std::size_t block = 4096;

void add_noise(const BenchPlan& plan, BenchReport& report) {
    Stream stream({.seed = 1, .purpose = "bench"});
    std::vector<double> numbers(block);
    std::uint32_t all = 0;
    const auto add = [&](BenchRate rate, const std::function<void()>& work) {
        rate.per_second = static_cast<double>(block) / seconds_per_call(plan.budget_s, work);
        report.add(std::move(rate));
    };
    add({.part = "receiver", .name = "random bits", .unit = "words of 32"}, [&] {
        for (std::size_t i = 0; i < block; ++i) all ^= stream.bits();
        numbers[0] = all;
    });
    add({.part = "receiver",
         .name = "normal numbers, one by one",
         .unit = "numbers",
         .limit = "random bits"},
        [&] {
            for (double& number : numbers) number = stream.normal();
        });
    add({.part = "receiver",
         .name = "normal numbers, in blocks",
         .unit = "numbers",
         .limit = "random bits"},
        [&] { stream.fill_normal(numbers); });
}

void add_chain(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    const Scene plate = scene.plate("plexiglass", 0.0);
    const Channel echo = echo_channel(plate, scene.catalogue.materials);
    const BeatSignal leak = dechirp(leakage_channel(plate.radar, {}), plate.radar.chirp);
    const ReceiverInput input{dechirp(echo, plate.radar.chirp), leak};
    const ReceiverChain chain(plate.radar);
    const auto samples = static_cast<double>(echo.h.size());
    report.add({.part = "receiver",
                .name = "dechirp",
                .unit = "samples",
                .per_second = samples / seconds_per_call(plan.budget_s, [&] {
                                  dechirp(echo, plate.radar.chirp);
                              })});
    std::vector<Complex> copy(echo.h.size());
    report.add({.part = "receiver",
                .name = "copying in memory",
                .unit = "samples",
                .per_second = samples / seconds_per_call(plan.budget_s, [&] {
                                  std::copy(echo.h.begin(), echo.h.end(), copy.begin());
                              })});
    std::uint32_t item = 0;
    const auto per_frame_s = seconds_per_call(plan.budget_s, [&] {
        Stream noise({.seed = 1, .purpose = "bench frame", .item = item++});
        chain.receive(input, {.displacement_m = 1e-5}, noise);
    });
    report.add({.part = "receiver",
                .name = "samples received, quantised",
                .unit = "samples",
                .per_second = samples / per_frame_s,
                .limit = "normal numbers, in blocks"});
}

}  // namespace

void bench_receiver(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    add_noise(plan, report);
    add_chain(plan, scene, report);
}

/// Labelled frames of sessions, everything included but the disk.
void bench_frames(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    const Bench bench = scene.sessions();
    for (const int frames : {1, 32, 128}) {
        Condition condition = scene.experiment.training;
        condition.frames = frames;
        condition.sessions = 1;
        int label = 0;
        const auto n_classes = static_cast<int>(bench.population.classes.size());
        const double seconds = seconds_per_call(plan.budget_s, [&] {
            for (label = 0; label < n_classes; ++label)
                simulate_session(bench, condition, {.world = 0, .label = label, .session = 0});
        });
        report.add({.part = "frames",
                    .name = frames == 1 ? std::string("frames, a new geometry each")
                                        : "frames, " + std::to_string(frames) + " per geometry",
                    .unit = "frames",
                    .per_second = n_classes * frames / seconds});
    }
}

}  // namespace specula
