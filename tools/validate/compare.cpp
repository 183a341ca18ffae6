#include "tools/validate/compare.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

double absolute_error(const ComplexPair& pair) {
    return std::abs(pair.computed - pair.expected);
}

double relative_error(const ComplexPair& pair) {
    const double scale = std::abs(pair.expected);
    return absolute_error(pair) / (scale > 0.0 ? scale : 1.0);
}

double level_error_db(const NumberPair& levels_db, double floor_db) {
    const auto& [computed, expected] = levels_db;
    if (std::isnan(computed) || std::isnan(expected)) return computed + expected;
    return std::abs(std::max(computed, floor_db) - std::max(expected, floor_db));
}

double amplitude_error_db(const ComplexPair& pair) {
    return level_error_db({amplitude_db(pair.computed), amplitude_db(pair.expected)});
}

double wrapped_error(const NumberPair& angles, double turn) {
    return std::abs(std::remainder(angles.computed - angles.expected, turn));
}

double phase_deg(Complex value) {
    return std::arg(value) * 180.0 / pi;
}

double amplitude_db(Complex amplitude) {
    return 20.0 * std::log10(std::abs(amplitude));
}

double power_db(double ratio) {
    return 10.0 * std::log10(ratio);
}

}  // namespace specula
