#pragma once

#include <optional>
#include <vector>

#include "scenes/radar.hpp"

namespace specula {

/// Powers of an infinite mirror at a height, from port to ADC.
struct LinkBudget {
    double received_dbm = 0.0;  ///< at the RX port
    double beat_hz = 0.0;
    double high_pass_db = 0.0;   ///< of the IF at that beat
    double amplitude_lsb = 0.0;  ///< of the tone in the ADC codes, behind the high-pass
    double noise_lsb = 0.0;      ///< rms per sample before the high-pass
};

/// @eq PHYSICS.md#image-source, #thermal-noise, #high-pass
LinkBudget mirror_budget(const Radar& radar, double height_m);

/// One place between TX port and ADC.
struct BudgetStage {
    const char* name;
    double echo_dbm;
    std::optional<double> noise_dbm;  ///< over half the sample rate; none before the receiver
};

/// The echo of an infinite mirror and the noise at every stage, in the order of the signal.
///
/// The noise behind the high-pass counts what the filter leaves of white noise, and at the ADC that
/// of its own and of rounding (1/12 LSB^2).
std::vector<BudgetStage> budget_stages(const Radar& radar, double height_m);

/// Amplitude in LSB as the power of such a tone behind the gain, and back.
double power_of_lsb_dbm(const Radar& radar, double amplitude_lsb);

}  // namespace specula
