#include "classifier/training_speed.hpp"

#include <ctime>

#include "classifier/train.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

double thread_cpu_s() {
    timespec now{};
    if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0)
        throw SystemError("clock: the system does not tell a thread's processor time");
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

FeatureTable random_rows(const TrainingWorkload& workload) {
    Stream stream({.seed = 1, .purpose = "training speed"});
    FeatureTable rows;
    rows.extractor = "random";
    rows.n_features = workload.n_features;
    for (std::size_t c = 0; c < workload.n_classes; ++c)
        rows.class_names.push_back(format("class {}", c));
    for (std::size_t i = 0; i < workload.n_rows; ++i) {
        rows.label.push_back(static_cast<std::uint8_t>(i % workload.n_classes));
        for (std::size_t f = 0; f < workload.n_features; ++f)
            rows.features.push_back(static_cast<float>(stream.normal()));
    }
    rows.world.assign(rows.size(), 0);
    rows.session.assign(rows.size(), 0);
    return rows;
}

}  // namespace

TrainingSpeed measure_training_speed(const TrainingWorkload& workload) {
    const FeatureTable rows = random_rows(workload);
    TrainingCurve curve;
    const double start_s = thread_cpu_s();
    train(rows, workload.options, {.seed = 1, .purpose = "training speed"}, {.curve = &curve});
    TrainingSpeed speed{.cpu_s = thread_cpu_s() - start_s};
    const auto n_epochs = static_cast<double>(curve.loss.size());
    const auto n_rows = static_cast<double>(workload.n_rows);
    speed.examples_per_cpu_s = n_rows * n_epochs / speed.cpu_s;
    speed.cpu_us_per_step =
        1e6 * static_cast<double>(workload.options.batch_size) / speed.examples_per_cpu_s;
    return speed;
}

}  // namespace specula
