#include "sim/link_budget.hpp"

#include <cmath>

#include "sim/adc/receiver_chain.hpp"
#include "sim/clutter.hpp"

namespace specula {

LinkBudget mirror_budget(const Radar& radar, double height_m) {
    LinkBudget budget;
    budget.received_dbm =
        radar.tx_power_dbm + 20.0 * std::log10(mirror_transfer(radar, height_m));
    budget.beat_hz = radar.chirp.beat_hz(height_m);
    const double below_beat = radar.receiver.high_pass_hz / budget.beat_hz;  // the corner, may be 0
    budget.high_pass_db = -20.0 * std::log10(1.0 + below_beat * below_beat);
    budget.amplitude_lsb = radar.amplitude_lsb(budget.received_dbm + budget.high_pass_db);
    budget.noise_lsb = ReceiverChain(radar).noise_lsb();
    return budget;
}

}  // namespace specula
