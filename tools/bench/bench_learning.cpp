#include "classifier/extract_features.hpp"
#include "classifier/folded_model.hpp"
#include "classifier/predict.hpp"
#include "classifier/training_speed.hpp"
#include "sim/generate.hpp"
#include "tools/bench/parts.hpp"
#include "tools/bench/stopwatch.hpp"

namespace specula {

void bench_learning(const BenchPlan& plan, const BenchScene& scene, BenchReport& report) {
    constexpr int frames_per_session = 128, epochs = 4;
    Condition condition = scene.experiment.training;
    condition.frames = frames_per_session;
    condition.sessions = 2;
    const Dataset dataset = generate(scene.sessions(), condition, 1, 1);
    const auto n = static_cast<double>(dataset.n_frames());
    const auto add = [&](BenchRate rate, double frames, const std::function<void()>& work) {
        rate.part = "learning";
        rate.unit = "frames";
        rate.per_second = frames / seconds_per_call(plan.budget_s, work);
        report.add(std::move(rate));
    };
    add({.name = "features extracted"}, n,
        [&] { extract_features(dataset, scene.experiment.descriptor, 1); });
    const FeatureTable table = extract_features(dataset, scene.experiment.descriptor, 1);
    TrainOptions options = scene.experiment.classifier;
    options.epochs = epochs;
    Model model = train(table, options, {.seed = 1, .purpose = "bench"});
    add({.name = "frames predicted"}, n, [&] { predict(fold(model), table); });
    add({.name = "frames learnt from", .limit = "frames predicted"}, n * epochs,
        [&] { model = train(table, options, {.seed = 1, .purpose = "bench"}); });
    report.add({.part = "learning",
                .name = "rows learnt from, 12-32-16-5 by 128",
                .unit = "rows",
                .per_second = measure_training_speed().examples_per_cpu_s});
}

}  // namespace specula
