#pragma once

#include <cmath>
#include <complex>

#include "sim/core/constants.hpp"

namespace specula {

inline double decibel(double amplitude) {
    return 20.0 * std::log10(amplitude);
}

/// How far one complex transfer lies from another.
struct Deviation {
    double db;
    double phase_deg;
};
inline Deviation deviation(std::complex<double> found, std::complex<double> expected) {
    return {std::abs(decibel(std::abs(found) / std::abs(expected))),
            std::abs(std::arg(found / expected)) * 180.0 / pi};
}

}  // namespace specula
