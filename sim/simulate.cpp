#include "sim/simulate.hpp"

#include <cmath>

#include "sim/channel/path.hpp"
#include "sim/scene_target.hpp"
#include "sim/trace/trace.hpp"

namespace specula {

namespace {

TraceSettings trace_settings(const Solver& solver, const FrequencyComb& comb) {
    return {.highest_hz = comb.last_hz(),
            .accuracy_db = solver.accuracy_db,
            .max_bounces = solver.max_bounces};
}

}  // namespace

Channel echo_channel(const Scene& scene, const Library& materials) {
    const FrequencyComb comb = comb_of(scene.radar.chirp);
    const std::vector<Reflector> reflectors = reflectors_of(scene, materials);
    const Scatter scatter = trace(target_of(scene, reflectors), antennas_of(scene.radar, radar_placement(scene.pose)),
                                  trace_settings(scene.solver, comb));
    return channel_of(scatter, reflectors, comb);
}

Channel leakage_channel(const Radar& radar, const BoardDrift& drift) {
    const FrequencyComb comb = comb_of(radar.chirp);
    Channel channel = silent_channel(static_cast<int>(radar.rx.size()), comb);
    for (const Leakage& leak : radar.leakage) {
        const double db = leak.level_dbm + drift.leakage_db - radar.tx_power_dbm;
        add_path(channel, comb,
                 {.rx = leak.rx,
                  .length_m = 2.0 * leak.range_m,
                  .transfer = std::polar(std::pow(10.0, db / 20.0),
                                         leak.phase_rad + drift.leakage_rad)});
    }
    return channel;
}

AdcFrame simulate(const Scene& scene, const Library& materials, Stream& noise) {
    const Channel echo = echo_channel(scene, materials);
    const Channel still = leakage_channel(scene.radar, {});
    const ReceiverInput input{dechirp(echo, scene.radar.chirp), dechirp(still, scene.radar.chirp)};
    return ReceiverChain(scene.radar).receive(input, {}, noise);
}

}  // namespace specula
