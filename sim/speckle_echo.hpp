#pragma once

#include <cstdint>

#include "scenes/solver.hpp"
#include "sim/channel/channel.hpp"
#include "sim/trace/speckle.hpp"

namespace specula {

/// A body of a target with what its rough faces need.
struct RoughBody {
    int body = 0;
    const Reflector& reflector;
    std::uint64_t piece = 1;  ///< the heights belong to the piece, wherever it lies
};

/// The rough faces of a stack whose diffuse echo reaches a third of the accuracy asked for,
/// against a mirror at the same height; the others are left out.
std::vector<RoughLayer> rough_layers(const RoughBody& rough, const FrequencyComb& comb,
                                     double accuracy_db);

/// Adds to a scatter the diffuse echo of the rough faces of a body, drawn for its piece.
/// @eq PHYSICS.md#speckle
struct SpeckleScene {
    const Target& target;
    const AntennaSet& antennas;
    const FrequencyComb& comb;
    double accuracy_db = 0.1;
    std::optional<ThinPlate>& plate;  ///< ThinPlate::of the target
};
void add_speckle(Scatter& scatter, const SpeckleScene& scene, const RoughBody& rough);

}  // namespace specula
