#pragma once

#include "scenes/pose.hpp"
#include "scenes/radar.hpp"

namespace specula {

/// An antenna where it stands in the scene.
struct PlacedAntenna {
    Vector3 position_m = Vector3::Zero();
    Rotation rotation = Rotation::Identity();  ///< from the antenna's own frame to the scene
    Pattern pattern = IsotropicPattern{};

    /// Field pattern along a unit direction that leaves the antenna, in the scene's frame.
    Vector3 field_towards(const Vector3& direction) const {
        return rotation * field_pattern(pattern, rotation.transpose() * direction);
    }
};

/// The antennas of a radar.
struct AntennaSet {
    PlacedAntenna tx;
    std::vector<PlacedAntenna> rx;
};

AntennaSet antennas_of(const Radar& radar, const Placement& placement);

}  // namespace specula
