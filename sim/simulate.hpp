#pragma once

#include "scenes/scene.hpp"
#include "sim/adc/receiver_chain.hpp"
#include "sim/core/for_each.hpp"

namespace specula {

/// The echo of everything in the scene at every frequency of the radar's chirp, for each RX of
/// each TX.
Channel echo_channel(const Scene& scene, const Library& materials,
                     const ForEach& for_each = one_by_one);

/// An echo without drawing a piece, whatever the solver does with heights: the mean of |h|^2 over
/// all pieces like the scene's is |coherent|^2 + diffuse_power, at every RX and frequency.
struct MeanEcho {
    Channel coherent;
    std::vector<double> diffuse_power;  ///< (rx, frequency), as in Channel::h
};
MeanEcho mean_echo(const Scene& scene, const Library& materials);

/// How the board differs from its file during a session.
struct BoardDrift {
    double leakage_db = 0.0;
    double leakage_rad = 0.0;
};

/// What the board couples from its TX into its RX without any scene.
Channel leakage_channel(const Radar& radar, const BoardDrift& drift);

/// The radar's codes for an echo that is already known: echo -> beat -> ADC codes. The scene's
/// motion takes the place of the state's.
AdcFrame record(const Scene& scene, const Channel& echo, Stream& noise,
                const FrameState& state = {});

/// The whole simulator in words: scene -> lit points -> channel -> beat -> ADC codes.
AdcFrame simulate(const Scene& scene, const Library& materials, Stream& noise,
                  const ForEach& for_each = one_by_one);

}  // namespace specula
