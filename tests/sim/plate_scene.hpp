#pragma once

#include "sim/channel/channel.hpp"
#include "sim/core/constants.hpp"
#include "sim/trace/trace.hpp"

namespace specula {

/// In the middle of what the radars here use: where one frequency is enough.
inline constexpr double test_frequency_hz = 60e9;

/// A plate under one TX and one RX: what the reference cases describe.
struct PlateScene {
    Plate plate;
    Pose pose;
    Pattern pattern = IsotropicPattern{};
    Vector3 tx_m = Vector3::Zero();  ///< in the radar's frame
    Vector3 rx_m = Vector3::Zero();

    Radar radar() const {
        Radar radar;
        radar.pattern = pattern;
        radar.tx_position_m = tx_m;
        radar.rx = {ReceiveChannel{.position_m = rx_m}};
        return radar;
    }
    Placement plate_placement() const { return sample_placement(pose); }
    AntennaSet antennas() const { return antennas_of(radar(), radar_placement(pose)); }

    /// The plate, opaque, and screens that are in the way.
    Target target(const std::vector<Mesh>& screens = {}) const {
        std::vector<Body> bodies{plate_body(plate, plate_placement(), true, 0.0)};
        for (const Mesh& screen : screens) bodies.push_back(mesh_body(screen, true, 0.0));
        return Target(std::move(bodies));
    }
    /// As exact as need be for comparison with closed forms.
    Scatter scatter(double highest_hz) const {
        return trace(target(), antennas(), {.highest_hz = highest_hz, .accuracy_db = 1e-9});
    }
    Complex transfer(const Reflector& reflector, double frequency_hz) const {
        return direct_sum(scatter(frequency_hz), 0, {&reflector, 1}, frequency_hz);
    }
};

inline Reflector perfect_conductor() {
    return [](double frequency_hz) { return Stack{{}, PerfectConductor{}, frequency_hz}; };
}

/// A smooth slab in air whose permittivity does not depend on frequency.
inline Reflector slab(Complex permittivity, double thickness_m) {
    return [=](double frequency_hz) {
        return Stack{{Layer{.medium = {permittivity}, .thickness_m = thickness_m}},
                     HalfSpace{},
                     frequency_hz};
    };
}

/// |h| of an infinite mirror at a height below an isotropic pair.
inline double isotropic_mirror(double height_m, double frequency_hz) {
    return speed_of_light_m_s / frequency_hz / (4.0 * pi * 2.0 * height_m);
}

}  // namespace specula
