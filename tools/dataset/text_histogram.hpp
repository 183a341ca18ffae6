#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace specula {

/// Counts in intervals of equal width that begin at round numbers.
struct Histogram {
    double first = 0.0, width = 1.0;  ///< interval i begins at first + i * width
    std::vector<std::size_t> counts;
};

/// At most `most` intervals over all values, none of them empty at the ends; a width of 0 where all
/// values are the same.
/// @in  values  finite, at least one
Histogram histogram_of(const std::vector<float>& values, std::size_t most);

/// One line per interval: its bounds, its count, and a bar whose longest has 40 characters.
std::string text_histogram(const std::string& name, const std::string& unit,
                           const std::vector<float>& values);

}  // namespace specula
