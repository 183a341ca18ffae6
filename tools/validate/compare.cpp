#include "tools/validate/compare.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

double absolute_error(Complex computed, Complex expected) {
    return std::abs(computed - expected);
}

double relative_error(Complex computed, Complex expected) {
    const double scale = std::abs(expected);
    return std::abs(computed - expected) / (scale > 0.0 ? scale : 1.0);
}

double level_error_db(double computed_db, double expected_db, double floor_db) {
    if (std::isnan(computed_db) || std::isnan(expected_db)) return computed_db + expected_db;
    return std::abs(std::max(computed_db, floor_db) - std::max(expected_db, floor_db));
}

double amplitude_error_db(Complex computed, Complex expected) {
    return level_error_db(level_db(computed), level_db(expected));
}

double phase_error_deg(double computed_deg, double expected_deg) {
    return std::abs(std::remainder(computed_deg - expected_deg, 360.0));
}

double phase_deg(Complex value) {
    return std::arg(value) * 180.0 / pi;
}

double level_db(Complex amplitude) {
    return 20.0 * std::log10(std::abs(amplitude));
}

double power_db(double ratio) {
    return 10.0 * std::log10(ratio);
}

}  // namespace specula
