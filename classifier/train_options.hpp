#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "classifier/learning_rate.hpp"

namespace specula {

/// In what a network learns; the model it becomes is always float.
enum class Precision { float32, float64 };

struct TrainOptions {
    std::vector<int> hidden{16, 16};  ///< units per hidden layer; none: logistic regression
    int epochs = 60;                  ///< passes over the rows, >= 1
    int batch_size = 128;             ///< >= 2; batches are made equal, so about this
    double learning_rate = 1e-3;      ///< of Adam, > 0; of a schedule, the largest
    Schedule schedule = Schedule::constant;
    double weight_decay = 0.0;     ///< AdamW's, in [0, 1]: decoupled, weights only; 0: Adam
    double label_smoothing = 0.0;  ///< [0, 1): share of the target spread over all classes
    double mixup = 0.0;            ///< shares of two rows are of Beta(a, a); 0: none; 0.05 to 1
    /// Channels of the convolutions before the hidden layers; none: no convolution. The features
    /// are then taken as one row of neighbours, such as range bins.
    std::vector<int> convolution{};
    int kernel = 3;         ///< positions that a convolution sees at once; odd
    int patience = 0;       ///< epochs without a lower held-out loss before the end; 0: no end
    double held_out = 0.2;  ///< share of each class's sessions that patience waits on, in (0, 1)
    Precision precision = Precision::float32;
};

/// Throws InputError `option = value: problem; remedy` for what cannot work.
/// @in  n_features  of the rows, > 0
void check_options(const TrainOptions& options, std::size_t n_features);

/// For a model's provenance: (what, value), those that are off left out.
std::vector<std::pair<std::string, std::string>> option_list(const TrainOptions& options);

/// "adam", or "adamw" where weights decay.
std::string optimiser_name(const TrainOptions& options);

}  // namespace specula
