#pragma once

#include "classifier/train_options.hpp"

namespace specula {

/// What to train for the clock's sake: clouds of random rows.
struct TrainingWorkload {
    std::size_t n_rows = 4800;
    std::size_t n_features = 12;
    std::size_t n_classes = 5;
    TrainOptions options{.hidden = {32, 16}, .epochs = 60, .batch_size = 128};
};

struct TrainingSpeed {
    double cpu_s = 0.0;               ///< of the calling thread
    double examples_per_cpu_s = 0.0;  ///< rows times epochs over that time
    double cpu_us_per_step = 0.0;     ///< a batch forwards, backwards and an Adam step
};

/// Times one whole `train` on this thread: shuffling, standardising and the monitor included.
TrainingSpeed measure_training_speed(const TrainingWorkload& workload = {});

}  // namespace specula
