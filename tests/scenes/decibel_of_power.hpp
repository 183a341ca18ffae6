#pragma once

#include <cmath>

namespace specula {

inline double decibel_of_power(double ratio) {
    return 10.0 * std::log10(ratio);
}

}  // namespace specula
