#include <cmath>

#include "sim/core/format.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/scratch_folder.hpp"
#include "tools/generate/generate.hpp"

namespace specula {

/// Whole datasets into compressed files, smallest first, so that the memory of each shows.
void bench_generate(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    constexpr double fewest_frames = 1000.0, shortest_plan_s = 0.1;
    Recipe recipe = read_recipe({.file = scene.experiment.file}, scene.catalogue);
    const double first = plan.budget_s < shortest_plan_s ? 40.0 : fewest_frames;
    const int n_sizes = std::max(1, static_cast<int>(plan.growth_decades));
    for (int size = 0; size < n_sizes; ++size) {
        const double frames = first * std::pow(10.0, size);
        recipe.condition.frames = 25;
        recipe.worlds = 1;
        const auto per_world = static_cast<double>(recipe.n_frames());
        if (frames < per_world) recipe.condition.sessions = 1;
        recipe.worlds = std::max(
            1, static_cast<int>(std::lround(frames / static_cast<double>(recipe.n_frames()))));
        const ScratchFolder folder;
        const GenerateReport done =
            run_generate(recipe,
                         {.out = folder.path() / "frames.h5",
                          .share = {},
                          .threads = plan.threads,
                          .say = {},
                          .on_stop = "stopped; of a measurement nothing is kept"},
                         scene.catalogue.materials);
        const auto n = static_cast<double>(done.n_frames);
        report.generated.push_back({.frames = n,
                                    .threads = plan.threads,
                                    .frames_per_s = n / done.seconds,
                                    .bytes_per_s = done.bytes / done.seconds,
                                    .peak_memory_bytes = done.peak_resident_bytes});
        recipe = read_recipe({.file = scene.experiment.file}, scene.catalogue);
    }
}

}  // namespace specula
