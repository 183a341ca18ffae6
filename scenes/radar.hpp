#pragma once

#include <string>
#include <vector>

#include "scenes/antenna.hpp"
#include "scenes/chirp.hpp"

namespace specula {

/// From the antenna port of one RX to its ADC codes.
struct Receiver {
    double gain_db = 40.0;
    double noise_figure_db = 12.0;
    double temperature_k = 290.0;
    double high_pass_hz = 175e3;   ///< corner of each of two first-order poles
    double full_scale_dbm = 10.0;  ///< a tone of this power behind the gain just fills the ADC
    int adc_bits = 12;
};

/// One RX of the board, in the radar's own frame.
struct ReceiveChannel {
    Vector3 position_m = Vector3::Zero();
    bool inverted = false;  ///< fed with 180 degrees
    double dc_offset_lsb = 0.0;
};

/// TX power that reaches an RX inside the board or package: a tone of short apparent range.
struct Leakage {
    int rx = 0;
    double range_m = 0.0;    ///< apparent, one way
    double level_dbm = 0.0;  ///< at the RX port
    double phase_rad = 0.0;  ///< at the start frequency of the ramp
};

/// A radar: chirp, antennas and receivers. Every number's origin is in its file.
struct Radar {
    std::string name;
    std::string title;
    std::string source;
    Chirp chirp;
    int chirps_per_frame = 1;
    double tx_power_dbm = 11.0;
    Pattern pattern;  ///< of every antenna
    Vector3 tx_position_m = Vector3::Zero();
    std::vector<ReceiveChannel> rx{ReceiveChannel{}};
    Receiver receiver;
    std::vector<Leakage> leakage;

    /// ADC code amplitude of a tone of the given power at the RX port.
    double amplitude_lsb(double power_dbm) const;
    double adc_full_scale_lsb() const { return static_cast<double>(1 << (receiver.adc_bits - 1)); }
};

/// Reads one radar file; its name is the file's stem. See scenes/README.md for the keys.
Radar read_radar(const std::filesystem::path& file);

}  // namespace specula
