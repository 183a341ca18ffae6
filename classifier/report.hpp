#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace specula {

/// A mean over worlds and its 95 % percentile-bootstrap interval (worlds resampled).
struct Interval {
    double mean = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// Counts of (true class, predicted class).
struct Confusion {
    explicit Confusion(std::size_t n_classes = 0) : n(n_classes), counts(n_classes * n_classes) {}

    std::size_t n;
    std::vector<std::int64_t> counts;  ///< (true, predicted), row-major

    std::int64_t& at(std::size_t truth, std::size_t predicted) {
        return counts[truth * n + predicted];
    }
    std::int64_t at(std::size_t truth, std::size_t predicted) const {
        return counts[truth * n + predicted];
    }
};

/// Number of frames by the largest softmax probability, in equal bins of [0, 1].
struct ConfidenceHistogram {
    static constexpr std::size_t n_bins = 25;
    std::array<std::int64_t, n_bins> correct{};
    std::array<std::int64_t, n_bins> wrong{};
};

/// How one condition of the experiment came out, all worlds together.
struct ConditionReport {
    std::string name;   ///< as in the experiment file, e.g. "height"
    std::string title;  ///< for people, e.g. "Height 35 and 55 cm"
    Confusion confusion;
    ConfidenceHistogram confidence;
    std::int64_t n_frames = 0;
    std::vector<double> macro_f1_per_world;         ///< (world), in [0, 1]
    std::vector<double> macro_f1_merged_per_world;  ///< (world), classes merged as the experiment says
    Interval macro_f1;
    Interval macro_f1_merged;
    Interval mean_confidence;
};

}  // namespace specula
