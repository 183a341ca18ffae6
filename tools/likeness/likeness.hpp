#pragma once

#include <atomic>
#include <string>

#include "tools/likeness/likeness_rows.hpp"
#include "tools/likeness/recording_statistics.hpp"

namespace specula {

/// What the figure shows of one RX, recorded and simulated.
struct LikenessCurves {
    struct Pair {
        std::vector<double> recorded, simulated;
    };
    Pair mean_chirp;   ///< (sample), LSB
    Pair spectrum_db;  ///< (bin), dB over one LSB
    Pair noise_lsb;    ///< (bin), rms per sample
    Pair histogram;    ///< (step), share of the codes
    double histogram_begin_lsb = 0.0, histogram_step_lsb = 1.0;
};

struct Likeness {
    std::vector<LikenessRow> rows;
    std::vector<LikenessCurves> curves;  ///< (rx)
    std::size_t n_chirps = 0;
};

/// Sets a board's simulated chirps beside recorded ones.
///
/// The radar is simulated as its file says: leakage, offsets, start-up and noise come from there.
/// The room of the recording is not in any file: its tones are fitted to one chirp of the first
/// half of the recording, and the comparison is made with the second half. `done` counts RX.
Likeness compare_with_recording(const ChirpSeries& recording, const Radar& radar,
                                std::uint64_t seed, std::atomic<std::size_t>* done = nullptr);

}  // namespace specula
