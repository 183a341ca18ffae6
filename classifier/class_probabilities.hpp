#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace specula {

/// Logits or probabilities of examples, row-major, borrowed.
template <typename Scalar>
struct ClassRows {
    std::span<const Scalar> values;  ///< (example, class)
    std::size_t n_classes = 0;

    std::size_t size() const { return values.size() / n_classes; }
    std::span<const Scalar> row(std::size_t i) const {
        return values.subspan(i * n_classes, n_classes);
    }
};

/// Probabilities of the classes, each row adding up to 1, in double.
struct ClassProbabilities {
    std::size_t n_classes = 0;
    std::vector<double> values;  ///< (example, class), row-major

    std::size_t size() const { return values.size() / n_classes; }
    std::span<const double> row(std::size_t i) const {
        return std::span(values).subspan(i * n_classes, n_classes);
    }
};

/// Softmax of logits / temperature.
/// @in  temperature  > 0; above 1 makes confidences smaller
ClassProbabilities softmax(const ClassRows<float>& logits, double temperature = 1.0);

/// Mean of -ln(probability of the true class), in nats, from the logits: finite however sure the
/// network is.
/// @in  truth  (example), each < n_classes; at least one
double negative_log_likelihood(const ClassRows<float>& logits, std::span<const std::uint8_t> truth,
                               double temperature = 1.0);

/// Mean over examples of the sum over classes of (probability - [is the class])^2, in [0, 2].
/// @eq  Brier 1950, Monthly Weather Review 78, equation (2)
double brier_score(const ClassProbabilities& probabilities, std::span<const std::uint8_t> truth);

/// The temperature that makes the negative log-likelihood least, by golden-section search over its
/// logarithm: the likelihood has a single minimum in 1 / temperature.
///
/// Fit it on nominal data only; classes, and so every F1, stay as they are.
/// @out  [0.01, 100]
/// @eq   Guo et al. 2017, arXiv 1706.04599, equation (9)
double fit_temperature(const ClassRows<float>& logits, std::span<const std::uint8_t> truth);

/// One bin of a reliability diagram.
struct ReliabilityBin {
    std::size_t n = 0;
    double confidence = 0.0;  ///< mean of its examples; 0 where there are none
    double accuracy = 0.0;    ///< share that is right; 0 where there are none
};

/// Examples by their confidence in equal bins (b / n, (b + 1) / n], 0 in the first.
struct Reliability {
    std::vector<ReliabilityBin> bins;
    /// Sum over bins of share |accuracy - confidence|, in [0, 1].
    /// @eq  Guo et al. 2017, equation (3)
    double expected_calibration_error = 0.0;
    double mean_confidence = 0.0;
    double accuracy = 0.0;
};

inline constexpr int reliability_bins = 15;

/// @in  probabilities  at least one example
Reliability reliability_of(const ClassProbabilities& probabilities,
                           std::span<const std::uint8_t> truth, int n_bins = reliability_bins);

}  // namespace specula
