#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace specula {

/// Added to the variance inside the square root; part of what a model means.
inline constexpr double batch_norm_epsilon = 1e-5;

/// x -> ReLU(gamma * (weight x - mean) / sqrt(variance + batch_norm_epsilon) + beta).
///
/// No bias before the normalisation, which would cancel it: its exact gradient is 0, and Adam turns
/// the rounding noise that is left into steps of the size of the learning rate.
struct HiddenLayer {
    std::size_t n_in = 0;
    std::size_t n_out = 0;
    std::vector<float> weight;    ///< (out, in)
    std::vector<float> gamma;     ///< (out)
    std::vector<float> beta;      ///< (out)
    std::vector<float> mean;      ///< (out), running mean over batches
    std::vector<float> variance;  ///< (out), running unbiased variance, >= 0
};

/// x -> weight x + bias.
struct OutputLayer {
    std::size_t n_in = 0;
    std::size_t n_out = 0;
    std::vector<float> weight;  ///< (out, in)
    std::vector<float> bias;    ///< (out)
};

/// A trained classifier as training left it: batch normalisation is not folded.
struct Model {
    std::string extractor;                 ///< name of the firmware's extractor it was trained on
    std::vector<std::string> class_names;  ///< (class)
    std::vector<float> input_mean;         ///< (feature); the network sees (x - mean) * scale
    std::vector<float> input_scale;        ///< (feature), >= 0
    std::vector<HiddenLayer> hidden;
    OutputLayer output;
    /// Where it comes from, for people: (what, value), e.g. ("dataset", a fingerprint).
    std::vector<std::pair<std::string, std::string>> provenance;

    std::size_t n_features() const { return input_mean.size(); }
    std::size_t n_classes() const { return class_names.size(); }
};

}  // namespace specula
