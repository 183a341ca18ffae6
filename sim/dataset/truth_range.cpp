#include "sim/dataset/truth_range.hpp"

#include <array>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr ValueRange length_range{0.0, longest_m};
constexpr ValueRange place_range{-longest_m, longest_m};
constexpr ValueRange tilt_range{-pi, pi};
constexpr ValueRange turns_range{-4.0 * pi, 4.0 * pi};  ///< a law's angle and its error
constexpr ValueRange level_db_range{-1000.0, 1000.0};
constexpr ValueRange factor_range{0.0, 1000.0};

/// In the order of truth_columns.
constexpr std::array<ValueRange, truth_columns.size()> ranges{{
    length_range,    // height
    length_range,    // nominal height
    tilt_range,      // sensor, x
    tilt_range,      // sensor, y
    tilt_range,      // sample, x
    tilt_range,      // sample, y
    place_range,     // offset, x
    place_range,     // offset, y
    turns_range,     // yaw
    length_range,    // size, x
    length_range,    // size, y
    length_range,    // thickness
    place_range,     // bow
    length_range,    // roughness
    length_range,    // correlation length
    factor_range,    // permittivity
    factor_range,    // loss
    level_db_range,  // gain
    place_range,     // displacement
}};

}  // namespace

const ValueRange& truth_range(std::size_t column) {
    return ranges.at(column);
}

std::string range_problem(const ValueRange& range, double value) {
    if (!std::isfinite(value)) return "is not finite";
    if (value >= range.least && value <= range.most) return "";
    return format("is not between {:.4g} and {:.4g}", range.least, range.most);
}

std::string truth_problem(std::size_t column, double value) {
    return range_problem(truth_range(column), value);
}

}  // namespace specula
