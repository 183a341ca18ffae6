#pragma once

#include <functional>
#include <string>
#include <vector>

namespace specula {

/// What the values of an axis may be, in the unit that the user writes them in.
struct AxisRules {
    std::string unit;  ///< "deg"
    double min = 0.0;
    double max = 0.0;
    bool min_excluded = false;
};

/// Says what is wrong with an axis and what would do; throws.
using Refusal = std::function<void(const std::string& problem, const std::string& remedy)>;

inline constexpr std::size_t most_values_per_axis = 100'000;

/// The values that a text names: "a", "first:last:step", or several of these with commas between.
///
/// The last value of a range belongs to it if whole steps lead there. Values are rounded to 1e-9,
/// so that a range from -10 by 0.1 meets zero.
/// @out  in ascending order, each once
std::vector<double> read_axis(const std::string& text, const AxisRules& rules,
                              const Refusal& refuse);

/// The words of a list with commas between, without blanks around them; an empty one is refused.
std::vector<std::string> read_words(const std::string& text, const Refusal& refuse);

}  // namespace specula
