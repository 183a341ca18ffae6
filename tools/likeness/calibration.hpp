#pragma once

#include <atomic>

#include "tools/likeness/recording_statistics.hpp"
#include "tools/likeness/tone_fit.hpp"

namespace specula {

/// The noise of a recording, taken apart by its shape over frequency.
struct NoiseFit {
    double before_lsb = 0.0;  ///< thermal, before the high-pass, rms per sample
    double behind_lsb = 0.0;  ///< IF amplifier and ADC, rounding not counted
    double quiet_lsb = 0.0;   ///< rms per sample in the quietest bins, rounding counted
    int first_quiet_bin = 0;
    int last_quiet_bin = 0;
};

/// A board as a recording shows it.
struct Calibration {
    Radar radar;                                ///< the given one with the fitted values in it
    std::vector<FittedChannel> channels;        ///< (rx): leakage among the tones, near ones only
    std::vector<std::vector<FittedTone>> room;  ///< (rx): what stands farther away
    std::vector<NoiseFit> noise;                ///< (rx)
    std::size_t n_chirps = 0;
    bool knows_gain = false;  ///< whether a known scene was there to tell
};

struct CalibrationSettings {
    double leakage_reach_m = 0.15;  ///< nearer tones are the board's own
    int most_leakage_tones = 4;     ///< per RX
    int most_room_tones = 24;
};

/// Estimates noise, DC offset, start-up pulse, leakage and, by a known scene, gain.
///
/// The mean chirp is taken apart into offset, pulse, the known echo and tones, near ones being
/// leakage and far ones the room. Noise is what differs between chirps in a row; where the
/// recording moves, only bins that do not are used. The noise figure is kept where the ADC's own
/// noise can explain the rest, and lowered where the recording is quieter than it says.
/// @in  echo  of the known scene per unit of transmitted amplitude; none: empty scene, gain is kept
/// `done` counts RX. Throws InputError where the recording does not fit the radar or has fewer than
/// three chirps.
Calibration calibrate(const ChirpSeries& series, const Radar& radar, const BeatSignal* echo,
                      const CalibrationSettings& settings = {},
                      std::atomic<std::size_t>* done = nullptr);

/// The radar file of a calibrated board: the values in numbers, antennas and limits as the board's
/// own file describes them.
std::string radar_file_text(const Radar& radar, const std::string& provenance);

}  // namespace specula
