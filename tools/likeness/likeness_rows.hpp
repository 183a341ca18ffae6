#pragma once

#include <string>
#include <vector>

#include "scenes/radar.hpp"

namespace specula {

/// All that is asked of one RX's chirps.
struct Portrait {
    std::vector<double> mean_chirp;     ///< (sample), LSB
    std::vector<double> mean_spectrum;  ///< (bin), mean over chirps of the amplitude, LSB
    std::vector<double> leakage;        ///< (bin), amplitude of the mean chirp, LSB
    std::vector<double> noise;          ///< (bin), rms per sample, LSB
    std::vector<double> codes;          ///< all, ascending
    std::vector<double> room_chirp;     ///< (bin), amplitude of the chirp that the room is taken from
};

/// One number of the recording beside that of the simulation.
struct LikenessRow {
    std::string quantity;
    std::string unit;
    int rx = 0;
    double recorded = 0.0;
    double simulated = 0.0;
    std::string reason;  ///< why they differ; empty where they are alike, or where nothing shows why

    /// Within 20 %, or within what one code can tell.
    bool is_alike() const;
};

/// The comparison of every RX, recorded beside simulated, (rx) each.
///
/// A difference has a reason only where the chirps themselves show its cause; each reason is a
/// test, and a difference that passes none stays unexplained.
std::vector<LikenessRow> likeness_rows(const std::vector<Portrait>& recorded,
                                       const std::vector<Portrait>& simulated, const Radar& radar);

}  // namespace specula
