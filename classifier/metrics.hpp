#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "classifier/report.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// Counts pairs of (true class, predicted class).
/// @in  truth, predicted  (example), each < n_classes
Confusion confusion_of(std::span<const std::uint8_t> truth, std::span<const std::uint8_t> predicted,
                       std::size_t n_classes);

/// The same counts with classes put together.
/// @in  merged_class  (class) -> merged class, 0 .. n_merged - 1, each of them used
Confusion merge_classes(const Confusion& confusion, std::span<const int> merged_class);

/// F1 = 2 TP / (2 TP + FP + FN), averaged over the classes that occur in the truth.
///
/// A class that only occurs among the predictions has no row of its own to be right about: it costs
/// the true classes their recall, but adds no zero. (scikit-learn averages over those too.)
/// @in   confusion  at least one count
/// @out  [0, 1]
double macro_f1(const Confusion& confusion);

/// Share of each true class that was recognised, in [0, 1]; nothing for classes not in the truth.
std::vector<std::optional<double>> recall_per_class(const Confusion& confusion);

/// The domain in which a model does worst.
struct WorstDomain {
    std::size_t domain = 0;  ///< the first of equals
    double macro_f1 = 0.0;
};
/// @in  macro_f1_per_domain  at least one, finite
WorstDomain worst_domain(std::span<const double> macro_f1_per_domain);

/// Mean over worlds with its 95 % percentile-bootstrap interval, 10,000 resamples of the worlds.
///
/// The same key and number of worlds give the same resamples: intervals of several quantities, or
/// of paired differences, rest on the same draws. One world: low = high = mean.
/// @in  per_world  at least one, finite
/// Limit: frames of a world are not independent, so only whole worlds are resampled; with few of
/// them the interval is too narrow.
Interval bootstrap_mean(const std::vector<double>& per_world, const StreamKey& key);

/// A share, (sum of parts) / (sum of wholes), with its interval as bootstrap_mean draws it;
/// resamples in which nothing is counted are left out.
/// @in  parts, wholes  (world), 0 <= part <= whole; at least one whole above 0
Interval bootstrap_share(const std::vector<double>& parts, const std::vector<double>& wholes,
                         const StreamKey& key);

}  // namespace specula
