#pragma once

#include "sim/adc/receiver_chain.hpp"

namespace specula {

/// A radar that neither makes noise nor colours the spectrum.
inline Radar quiet_radar() {
    Radar radar;
    radar.receiver.temperature_k = 1e-30;
    radar.receiver.high_pass_hz = 0.0;
    return radar;
}

inline AdcFrame receive(const Radar& radar, const ReceiverInput& input,
                        const FrameState& state = {}) {
    Stream noise({.seed = 1, .purpose = "thermal noise"});
    return ReceiverChain(radar).receive(input, state, noise);
}

}  // namespace specula
