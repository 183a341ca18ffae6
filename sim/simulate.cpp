#include "sim/simulate.hpp"

#include <algorithm>
#include <cmath>

#include "sim/channel/diffuse_power.hpp"
#include "sim/channel/layer_path.hpp"
#include "sim/channel/path.hpp"
#include "sim/every_tx.hpp"
#include "sim/height_field.hpp"
#include "sim/scene_target.hpp"
#include "sim/speckle_echo.hpp"
#include "sim/trace/trace.hpp"

namespace specula {

namespace {

TraceSettings trace_settings(const Solver& solver, const FrequencyComb& comb,
                             std::span<const Reflector> reflectors) {
    TraceSettings settings{.highest_hz = comb.last_hz(),
                           .accuracy_db = solver.accuracy_db,
                           .max_bounces = solver.max_bounces,
                           .edge_currents = solver.edge_currents,
                           .lowest_hz = comb.first_hz};
    for (const Reflector& reflector : reflectors)
        settings.layer_path_m =
            std::max(settings.layer_path_m, layer_path_m(reflector(comb.at(comb.n / 2))));
    return settings;
}

/// A scene ready to be traced.
struct Stage {
    FrequencyComb comb;
    std::vector<Reflector> reflectors;  ///< (body)
    Target target;
    AntennaSet antennas;
    TraceSettings settings;

    Stage(const Scene& scene, const Library& materials)
        : comb(comb_of(scene.radar.chirp)),
          reflectors(reflectors_of(scene, materials)),
          target(target_of(scene, reflectors)),
          antennas(antennas_of(scene.radar, radar_placement(scene.pose))),
          settings(trace_settings(scene.solver, comb, reflectors)) {}
};

/// The bodies whose roughness scatters, in the order of the reflectors.
std::vector<RoughBody> rough_bodies(const Scene& scene, const Stage& stage) {
    std::vector<RoughBody> bodies;
    if (scene.solver.roughness == Solver::Roughness::coherent) return bodies;
    for (std::size_t i = 0; i < stage.reflectors.size(); ++i)
        bodies.push_back({static_cast<int>(i), stage.reflectors[i],
                          i == 0 ? scene.sample.piece : scene.objects[i - 1].matter.piece});
    return bodies;
}

}  // namespace

Channel echo_channel(const Scene& asked, const Library& materials, const ForEach& for_each) {
    if (asked.radar.n_tx() > 1)
        return channel_of_every_tx(asked.radar, [&](const Radar& one) {
            Scene with_one = asked;
            with_one.radar = one;
            return echo_channel(with_one, materials, for_each);
        });
    const bool explicit_heights = asked.solver.roughness == Solver::Roughness::height_field;
    const Scene scene = explicit_heights ? with_height_field(asked) : asked;
    const Stage stage(scene, materials);
    std::optional<ThinPlate> plate = ThinPlate::of(stage.target, stage.antennas, stage.settings);
    Scatter scatter = trace(stage.target, stage.antennas, stage.settings, plate);
    const SpeckleScene speckle{stage.target, stage.antennas, stage.comb, stage.settings.accuracy_db,
                               plate};
    for (const RoughBody& body : rough_bodies(scene, stage)) add_speckle(scatter, speckle, body);
    return channel_of(scatter, stage.reflectors, stage.comb, for_each);
}

MeanEcho mean_echo(const Scene& scene, const Library& materials) {
    const Stage stage(scene, materials);
    const Scatter scatter = trace(stage.target, stage.antennas, stage.settings);
    MeanEcho echo{.coherent = channel_of(scatter, stage.reflectors, stage.comb),
                  .diffuse_power = {}};
    echo.diffuse_power.resize(echo.coherent.h.size(), 0.0);
    for (const RoughBody& body : rough_bodies(scene, stage)) {
        for (const RoughLayer& layer : rough_layers(body, stage.comb, scene.solver.accuracy_db)) {
            const std::vector<double> power = mean_diffuse_power(
                diffuse_cells(stage.target, stage.antennas, layer), stage.reflectors, stage.comb);
            for (std::size_t i = 0; i < power.size(); ++i) echo.diffuse_power[i] += power[i];
        }
    }
    return echo;
}

Channel leakage_channel(const Radar& radar, const BoardDrift& drift) {
    if (radar.n_tx() > 1)
        return channel_of_every_tx(radar,
                                   [&](const Radar& one) { return leakage_channel(one, drift); });
    const FrequencyComb comb = comb_of(radar.chirp);
    Channel channel = silent_channel(static_cast<int>(radar.rx.size()), comb);
    for (const Leakage& leak : radar.leakage) {
        const double db = leak.level_dbm + drift.leakage_db - radar.tx_power_dbm;
        add_path(channel, comb,
                 {.rx = leak.rx,
                  .length_m = 2.0 * leak.range_m,
                  .transfer =
                      std::polar(std::pow(10.0, db / 20.0), leak.phase_rad + drift.leakage_rad)});
    }
    return channel;
}

AdcFrame record(const Scene& scene, const Channel& echo, Stream& noise, const FrameState& state) {
    const Channel still = leakage_channel(scene.radar, {});
    const ReceiverInput input{dechirp(echo, scene.radar.chirp), dechirp(still, scene.radar.chirp)};
    FrameState moving = state;
    moving.motion = scene.motion;
    return ReceiverChain(scene.radar).receive(input, moving, noise);
}

AdcFrame simulate(const Scene& scene, const Library& materials, Stream& noise,
                  const ForEach& for_each) {
    return record(scene, echo_channel(scene, materials, for_each), noise);
}

}  // namespace specula
