#pragma once

#include <limits>
#include <optional>

#include "scenes/vector3.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// From the antenna port of one RX to its ADC codes.
struct Receiver {
    double gain_db = 40.0;
    double noise_figure_db = 12.0;
    double temperature_k = 290.0;
    double high_pass_hz = 175e3;        ///< corner of the first of two first-order poles
    double second_high_pass_hz = -1.0;  ///< of the second; below 0: the same
    double full_scale_dbm = 10.0;       ///< a tone of this power behind the gain just fills the ADC
    int adc_bits = 12;
    bool complex_samples = false;  ///< I and Q; else I alone
    double adc_noise_lsb = 0.0;    ///< rms, white, of IF amplifier and ADC behind the high-pass
    /// Single-sideband phase noise of the ramp 1 MHz off the carrier, falling by 20 dB per decade;
    /// minus infinity: none.
    double phase_noise_dbc_hz = -std::numeric_limits<double>::infinity();
    /// Where the first input of the decimation filter lies between its output samples, in samples.
    double start_up_fraction = 0.0;

    /// What the two poles leave of an amplitude, in dB; 0 or less.
    double high_pass_db(double beat_hz) const;
    static Receiver read(Section section);
};

/// One RX of the board, in the radar's own frame.
struct ReceiveChannel {
    Vector3 position_m = Vector3::Zero();
    bool inverted = false;       ///< fed with 180 degrees
    double dc_offset_lsb = 0.0;  ///< of both rails where there are two
    double gain_db = 0.0;        ///< off the receiver's, feed included
    double phase_rad = 0.0;      ///< of the feed
    double start_up_lsb = 0.0;   ///< pulse with which the decimation filter starts

    static ReceiveChannel read(Section section);
};

/// TX power that reaches an RX inside the board or package: a tone of short apparent range.
struct Leakage {
    int rx = 0;
    std::optional<int> tx{};  ///< of this TX only; none: of each
    double range_m = 0.0;     ///< apparent, one way
    double level_dbm = 0.0;   ///< at the RX port
    double phase_rad = 0.0;   ///< of the coupling: h = |h| exp(j phase) exp(-jk 2 range)

    /// How many channels the board has, for the checks.
    struct Board {
        std::size_t n_rx;
        std::size_t n_tx;
    };
    static Leakage read(Section section, const Board& board);
};

/// A second radar in the room: its ramps cross ours, and each crossing leaves a short chirp.
struct Interferer {
    double level_dbm = 0.0;  ///< at every RX port while it sends
    double start_hz = 0.0;
    double slope_hz_s = 0.0;
    double ramp_s = 0.0;    ///< how long each of its ramps sweeps
    double period_s = 0.0;  ///< from ramp to ramp

    static Interferer read(Section section);
};

}  // namespace specula
