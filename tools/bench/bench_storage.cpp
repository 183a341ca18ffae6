#include <filesystem>
#include <fstream>

#include "sim/generate.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/scratch_folder.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr int frames_per_session = 64;

}  // namespace

void bench_storage(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    Condition condition = scene.experiment.training;
    condition.frames = frames_per_session;
    condition.sessions = 2;
    const Dataset dataset = generate(scene.sessions(), condition, 1, 1);
    const auto bytes = static_cast<double>(dataset.adc.size() * sizeof(dataset.adc[0]));
    const ScratchFolder folder;
    const auto add = [&](BenchRate rate, const std::function<void()>& work) {
        rate.part = "storage";
        rate.unit = "bytes of codes";
        rate.per_second = bytes / seconds_per_call(plan.budget_s, work);
        report.add(std::move(rate));
    };
    add({.name = "plain file"}, [&] {
        std::ofstream(folder.path() / "plain", std::ios::binary)
            .write(reinterpret_cast<const char*>(dataset.adc.data()),
                   static_cast<std::streamsize>(bytes));
    });
    const fs::path file = folder.path() / "frames.h5";
    add({.name = "HDF5 written, compressed", .limit = "plain file"},
        [&] { write_dataset(file, dataset); });
    add({.name = "HDF5 read", .limit = "plain file"}, [&] { read_dataset(file); });
}

}  // namespace specula
