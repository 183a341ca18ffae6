#pragma once

#include <string>

#include "sim/dataset/truth.hpp"

namespace specula {

/// Both ends are in it.
struct ValueRange {
    double least, most;
};

inline constexpr double longest_m = 1000.0;
/// A range bin; 0: unknown.
inline constexpr ValueRange possible_bin_m{0.0, longest_m};

/// The values that a column of the truth may have, in its own unit. Wider than any law of this
/// program allows; what lies outside was not measured but damaged, or is of another unit.
const ValueRange& truth_range(std::size_t column);

/// What is wrong with a value, "is not between 0 and 1000"; empty where nothing is.
std::string range_problem(const ValueRange& range, double value);
std::string truth_problem(std::size_t column, double value);

}  // namespace specula
