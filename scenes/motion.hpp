#pragma once

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// How a sample moves while a frame is recorded; away from the radar counts positive.
struct Motion {
    double velocity_m_s = 0.0;
    double vibration_m = 0.0;  ///< peak
    double vibration_hz = 0.0;
    double vibration_rad = 0.0;  ///< phase when the frame begins

    bool is_rest() const { return velocity_m_s == 0.0 && vibration_m == 0.0; }
    double displacement_m(double time_s) const {
        return velocity_m_s * time_s +
               vibration_m * std::sin(two_pi * vibration_hz * time_s + vibration_rad);
    }

    static Motion read(Section section);
};

}  // namespace specula
