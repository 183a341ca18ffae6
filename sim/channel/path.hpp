#pragma once

#include "sim/channel/channel.hpp"

namespace specula {

/// One discrete way from TX to an RX: leakage on the board, or a small object in the room.
struct Path {
    int rx = 0;
    double length_m = 0.0;       ///< from phase centre to phase centre
    Complex transfer{0.0, 0.0};  ///< h = transfer exp(-jk length)
};

/// An all-zero channel with room for every RX and frequency.
Channel silent_channel(int n_rx, const FrequencyComb& comb);

void add_path(Channel& channel, const FrequencyComb& comb, const Path& path);

}  // namespace specula
