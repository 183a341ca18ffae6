#include "scenes/transmitter.hpp"

#include <bit>

#include "sim/core/constants.hpp"

namespace specula {

TransmitChannel TransmitChannel::read(Section section) {
    const auto p = section.quantities("position", Unit::length, 2, Range::between(-1.0, 1.0));
    TransmitChannel channel{
        .position_m = {p[0], p[1], 0.0},
        .inverted = section.flag("inverted", false),
        .gain_db = section.quantity("gain", Unit::ratio_db, Range::between(-40.0, 40.0), 0.0),
        .phase_rad = section.quantity("phase", Unit::angle, Range::between(-two_pi, two_pi), 0.0),
    };
    section.finish();
    return channel;
}

double tx_weight(Multiplexing multiplexing, int tx, const TxTurn& turn) {
    if (multiplexing == Multiplexing::tdm) return turn.chirp % turn.n_tx == tx ? 1.0 : 0.0;
    const unsigned columns = std::bit_ceil(static_cast<unsigned>(turn.n_tx));
    const unsigned column = static_cast<unsigned>(turn.chirp) % columns;
    return std::popcount(column & static_cast<unsigned>(tx)) % 2 == 0 ? 1.0 : -1.0;
}

Multiplexing read_multiplexing(Section& section, const std::string& key) {
    return section.choice(key, {"tdm", "bpm"}, "tdm") == "tdm" ? Multiplexing::tdm
                                                               : Multiplexing::bpm;
}

}  // namespace specula
