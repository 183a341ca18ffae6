#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "sim/dataset/dataset.hpp"

namespace specula {

/// Least, mean and most of some values.
struct Spread {
    double least = INFINITY, most = -INFINITY, sum = 0.0;
    std::size_t n = 0;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
        sum += value;
        ++n;
    }
    double mean() const { return sum / static_cast<double>(n); }
};

struct ClassSummary {
    std::string name;
    std::size_t n_frames = 0;
    std::set<std::int32_t> samples, sessions;
    std::vector<double> profile_mean, profile_sd;  ///< (value of the profile)
    /// (example, value): of the first frame of at most three sessions.
    std::vector<std::vector<float>> examples;
};

/// A quantity of every frame, with the frame's class.
struct FrameQuantity {
    std::string name;  ///< for people, e.g. "height"
    std::string unit;
    std::vector<float> values;        ///< (frame), finite; as many as are known
    std::vector<std::uint8_t> label;  ///< of the same frames
};

/// What is in a dataset, found in one pass over it; memory grows by 20 bytes a frame.
struct DatasetSummary {
    Dataset head;  ///< origin, names and shapes, no frames
    std::size_t n_frames = 0;
    std::string fingerprint;  ///< of codes, profiles, features and labels
    std::set<std::int32_t> worlds, samples, sessions, views;
    std::vector<ClassSummary> classes;      ///< (class)
    std::vector<Spread> codes, quadrature;  ///< (rx)
    std::vector<Spread> features;           ///< (feature)
    std::vector<Spread> truth;              ///< (column), of unknown ones n = 0
    std::vector<FrameQuantity> quantities;  ///< height, tilts, SNR, as far as they are known
    std::string profile_axis;

    const FrameQuantity* quantity(const std::string& name) const;
};

/// Throws InputError as DatasetReader does. Shows progress where it takes long.
DatasetSummary summarise_dataset(const std::filesystem::path& file, int threads);

}  // namespace specula
