#pragma once

#include <cstdint>
#include <string>

#include "classifier/report.hpp"

namespace specula {

/// How the report writes numbers: one decimal, a true minus sign, and a space that does not break.

std::string fixed_text(double value, int n_decimals);   ///< "-0.0" is never written
std::string signed_text(double value, int n_decimals);  ///< "+2.4", "-0.4 with a true minus", "0.0"
std::string percent_number(double share);               ///< 0.942 -> "94.2"
std::string percent_text(double share);                 ///< 0.942 -> "94.2 %"
std::string points_text(double share);                  ///< 0.016 -> "1.6 points" (of a percentage)
std::string range_number(const Interval& interval);     ///< "93.1 to 95.8", for table cells
std::string range_text(const Interval& interval);       ///< "93.1 to 95.8 %"
std::string count_text(std::int64_t count);             ///< 12345 -> "12 345"

}  // namespace specula
