#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "classifier/measurement.hpp"

namespace specula {

/// Added to the variance inside the square root; part of what a model means.
inline constexpr double batch_norm_epsilon = 1e-5;

/// x -> gamma * (x - mean) / sqrt(variance + batch_norm_epsilon) + beta, where it stands alone.
struct BatchNorm {
    std::vector<float> gamma;
    std::vector<float> beta;
    std::vector<float> mean;
    std::vector<float> variance;  ///< >= 0
};

/// How the units of a layer see a row of positions: each its own neighbourhood, all with the same
/// weights; beyond the ends of the row there are zeros.
struct Convolution {
    std::size_t n_positions = 0;  ///< of what comes in and goes out, >= 1
    std::size_t kernel = 1;       ///< positions seen at once, odd
};

/// x -> ReLU(gamma * (weight x - mean) / sqrt(variance + batch_norm_epsilon) + beta).
///
/// No bias before the normalisation, which would cancel it: its exact gradient is 0, and Adam turns
/// the rounding noise that is left into steps of the size of the learning rate.
///
/// Networks trained elsewhere may have a bias, and their normalisation after the ReLU (TI's): then
/// gamma, beta, mean and variance are empty, and the layer is BatchNorm(ReLU(weight x + bias)).
struct HiddenLayer {
    std::size_t n_in = 0;
    std::size_t n_out = 0;
    std::vector<float> weight;              ///< (out, in)
    std::vector<float> gamma;               ///< (out)
    std::vector<float> beta;                ///< (out)
    std::vector<float> mean;                ///< (out), running mean over batches
    std::vector<float> variance;            ///< (out), running unbiased variance, >= 0
    std::vector<float> bias{};              ///< (out), or empty: none
    std::optional<BatchNorm> after_relu{};  ///< (out)
    /// Values of a row lie position by position, the channels of one side by side. Then weight is
    /// (channel out, kernel, channel in), and all that is one per output is one per channel.
    std::optional<Convolution> convolution{};
};

/// x -> weight x + bias.
struct OutputLayer {
    std::size_t n_in = 0;
    std::size_t n_out = 0;
    std::vector<float> weight;  ///< (out, in)
    std::vector<float> bias;    ///< (out)
};

/// The spread of the training features, for the firmware's fw_mahalanobis.
struct InputMonitor {
    std::vector<float> mean;       ///< (feature)
    std::vector<float> whitening;  ///< (feature (feature + 1) / 2), rows of a lower triangle
    std::vector<float> centre;     ///< (class, feature), whitened
    float suspicious_squared = 0;  ///< squared distance above which an input is unfamiliar, > 0
};

/// A few points that stand for the training rows; see Prototypes, which is this as a matrix.
struct InputPrototypes {
    std::vector<float> mean;    ///< (feature)
    std::vector<float> scale;   ///< (feature), >= 0; distances are of (x - mean) * scale
    std::vector<float> centre;  ///< (prototype, feature), at least one
};

/// A trained classifier as training left it: batch normalisation is not folded.
struct Model {
    std::string extractor;                  ///< name of the firmware's extractor it was trained on
    std::vector<std::string> class_names;   ///< (class)
    std::vector<float> input_mean;          ///< (feature); the network sees (x - mean) * scale
    std::vector<float> input_scale;         ///< (feature), >= 0
    std::optional<BatchNorm> input_norm{};  ///< (feature), behind mean and scale (TI's placement)
    std::vector<HiddenLayer> hidden;
    OutputLayer output;
    std::optional<Measurement> measurement{};  ///< how its features came about, if known
    std::optional<InputMonitor> monitor{};
    std::optional<InputPrototypes> prototypes{};
    std::vector<std::string> feature_names{};  ///< (feature) of named columns; empty: no names
    /// Where it comes from, for people: (what, value), e.g. ("dataset", a fingerprint).
    std::vector<std::pair<std::string, std::string>> provenance;

    std::size_t n_features() const { return input_mean.size(); }
    std::size_t n_classes() const { return class_names.size(); }
};

}  // namespace specula
