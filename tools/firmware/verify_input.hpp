#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "classifier/model.hpp"
#include "scenes/catalogue.hpp"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// Frames and a model to push through the firmware.
struct VerifyInput {
    Dataset frames;
    Model model;             ///< with its measurement
    std::string frames_are;  ///< where they come from, for the report
    std::string model_is;
};

struct VerifyRequest {
    std::filesystem::path
        dataset;                  ///< .h5, or .bin in the layout of ADC injection; empty: simulate
    std::filesystem::path model;  ///< empty: train one on the frames
    std::string descriptor;       ///< of the one trained here; empty: the paper's range bins
    std::vector<int> hidden;      ///< units of its hidden layers; empty: as `specula train`
    int most_frames = 1000;       ///< more are thinned out evenly
    int threads = 1;
};

/// Reads or simulates frames and reads or trains a model.
///
/// Frames without two classes (a recording) train a network on frame number modulo 5: its
/// arithmetic is as good as any other's, its answers mean nothing. Throws InputError where files
/// cannot be used or do not fit each other, or where a model that is given is told how to be made.
VerifyInput prepare_verification(const VerifyRequest& request, const Catalogue& catalogue);

}  // namespace specula
