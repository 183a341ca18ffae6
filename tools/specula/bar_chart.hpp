#pragma once

#include <string>
#include <vector>

namespace specula {

/// One line per value: label, value, a bar on a logarithmic scale from `floor` to the largest.
std::string bar_chart(const std::vector<std::string>& labels, const std::vector<float>& values,
                      double floor);

}  // namespace specula
