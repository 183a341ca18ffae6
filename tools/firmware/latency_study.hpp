#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "classifier/report.hpp"
#include "scenes/catalogue.hpp"
#include "tools/firmware/verification.hpp"
#include "tools/report/paired_difference.hpp"

namespace specula {

/// How the answers of a network in some arithmetic compare with those of the same in float32.
struct Agreement {
    std::string condition;    ///< "nominal" or the name of one
    double f1_change = 0.0;   ///< macro-F1 minus that in float32, mean over worlds
    double same_label = 0.0;  ///< share of frames with the same label
    double clipped = 0.0;     ///< share of frames with an input beyond the integers' reach
};

/// One network in one arithmetic: what it costs, and how well it names materials.
struct LatencyPoint {
    std::vector<int> hidden;
    std::string arithmetic;  ///< "float32", "int16", "int8"
    std::size_t n_multiplications = 0;
    std::size_t model_bytes = 0;
    double instructions = 0.0;                                    ///< of network and softmax
    CycleRange cycles;                                            ///< likewise, estimated
    StageCost features;                                           ///< frame -> what it sees
    std::vector<double> nominal_per_world, rerecorded_per_world;  ///< macro-F1
    Interval nominal, rerecorded;
    /// Against the largest network in float32, world by world.
    PairedDifference nominal_loss, rerecorded_loss;
    std::vector<Agreement> agreement;  ///< nominal, then every condition of the experiment
};

struct LatencyStudy {
    std::string experiment;
    int worlds = 0;
    int epochs = 0;
    std::string descriptor;  ///< what the networks see
    std::size_t n_features = FW_DEFAULT_N_BINS, n_classes = 5;
    std::size_t n_rows = 0;            ///< chirps of all receivers in a frame
    std::vector<LatencyPoint> points;  ///< by rising size, three arithmetics each
};

struct LatencyRequest {
    std::filesystem::path experiment_file;
    std::string descriptor;  ///< a line; empty: the experiment's range bins
    int worlds = 8;
    int threads = 1;
};

/// Trains networks of several sizes on the recordings of an experiment, quantises each, and
/// measures each on the emulated target.
///
/// Every size sees the same worlds, frames and stream of random numbers. Judged on the frames held
/// back and on the condition named "rerecorded" (or the first there is); integers are compared with
/// float32 under every condition, since it is far from the training rows that they part.
LatencyStudy study_latency(const LatencyRequest& request, const Catalogue& catalogue,
                           const Workplace& place);

/// As a table for a terminal, and as comma-separated text.
std::string latency_text(const LatencyStudy& study);
std::string latency_csv(const LatencyStudy& study);

}  // namespace specula
