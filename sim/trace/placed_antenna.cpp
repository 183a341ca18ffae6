#include "sim/trace/placed_antenna.hpp"

namespace specula {

AntennaSet antennas_of(const Radar& radar, const Placement& placement) {
    AntennaSet antennas;
    antennas.tx = {placement.point(radar.tx_position_m), placement.rotation, radar.pattern};
    for (const ReceiveChannel& channel : radar.rx)
        antennas.rx.push_back(
            {placement.point(channel.position_m), placement.rotation, radar.pattern});
    return antennas;
}

}  // namespace specula
