#pragma once

#include "scenes/radar.hpp"

namespace specula {

/// Powers of an infinite mirror at a height, from port to ADC.
struct LinkBudget {
    double received_dbm = 0.0;       ///< at the RX port
    double beat_hz = 0.0;
    double high_pass_db = 0.0;       ///< of the IF at that beat
    double amplitude_lsb = 0.0;      ///< of the tone in the ADC codes, behind the high-pass
    double noise_lsb = 0.0;          ///< rms per sample before the high-pass
};

/// @eq PHYSICS.md#image-source, #thermal-noise, #high-pass
LinkBudget mirror_budget(const Radar& radar, double height_m);

}  // namespace specula
