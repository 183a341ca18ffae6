#pragma once

#include <string_view>

#include "scenes/vector3.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// One TX of the board. Gain and phase are those of its feed; the first TX is what others refer to.
struct TransmitChannel {
    Vector3 position_m = Vector3::Zero();
    bool inverted = false;  ///< fed with 180 degrees
    double gain_db = 0.0;
    double phase_rad = 0.0;

    static TransmitChannel read(Section section);
};

/// How several TX share the chirps of a frame.
enum class Multiplexing {
    tdm,  ///< one after the other, chirp by chirp
    bpm,  ///< all at once, each with its own signs (rows of a Hadamard matrix)
};

/// Which chirp of how many TX.
struct TxTurn {
    int chirp = 0;
    int n_tx = 1;
};

/// What TX number `tx` sends in a chirp: 1, 0 or -1 times its amplitude.
///
/// TDM: chirp c belongs to TX c mod n. BPM: the sign of row `tx` of the Walsh-Hadamard matrix of
/// the next power of two, column c; with two TX the signs are ++ and +-, as in TI's pattern 4.
double tx_weight(Multiplexing multiplexing, int tx, const TxTurn& turn);

/// "tdm" or "bpm".
Multiplexing read_multiplexing(Section& section, const std::string& key);

}  // namespace specula
