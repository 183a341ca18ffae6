#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "classifier/report.hpp"

namespace specula {

/// `a - b`, world by world.
struct PairedDifference {
    Interval value;            ///< mean, and 95 % percentile bootstrap over worlds
    std::size_t n_worlds = 0;  ///< fewer than two: no interval
    std::size_t n_below = 0;   ///< worlds in which a < b

    /// The interval excludes zero.
    bool is_clear() const { return n_worlds > 1 && (value.low > 0.0 || value.high < 0.0); }
};

/// @in  a, b  (world), the same worlds in the same order; empty gives a zero difference
PairedDifference paired_difference(const std::vector<double>& a, const std::vector<double>& b,
                                   std::uint64_t seed);

/// "lower by 3.2 points (95 % interval 1.1 to 5.3)", "higher by ...", or "not clearly different
/// (-0.3 points, 95 % interval -1.5 to 0.9)".
std::string difference_text(const PairedDifference& difference);

}  // namespace specula
