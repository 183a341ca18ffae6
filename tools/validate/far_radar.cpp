#include "tools/validate/far_radar.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "tools/validate/plate_under_radar.hpp"

namespace specula {

namespace {

PlacedAntenna far_antenna(const FarWave& wave, double distance_m) {
    Rotation frame;
    frame.col(2) = wave.from;  // the boresight is -z, the field along y
    frame.col(1) = wave.polarisation;
    frame.col(0) = frame.col(1).cross(frame.col(2));
    return {distance_m * wave.from, frame, IsotropicPattern{}};
}

}  // namespace

Vector3 SphericalDirection::outward() const {
    return {std::sin(from_z_rad) * std::cos(from_x_rad),
            std::sin(from_z_rad) * std::sin(from_x_rad), std::cos(from_z_rad)};
}

Vector3 SphericalDirection::along_theta() const {
    return {std::cos(from_z_rad) * std::cos(from_x_rad),
            std::cos(from_z_rad) * std::sin(from_x_rad), -std::sin(from_z_rad)};
}

Vector3 SphericalDirection::along_phi() const {
    return {-std::sin(from_x_rad), std::cos(from_x_rad), 0.0};
}

Complex FarRadar::amplitude_from(double distance_m, const Target& target,
                                 const Waves& waves) const {
    Scatter scatter =
        trace(target, {far_antenna(sent, distance_m), {far_antenna(received, distance_m)}},
              {.highest_hz = frequency_hz, .accuracy_db = 1e-6, .max_bounces = waves.n_bounces});
    if (waves.these_only)
        std::erase_if(scatter.routes, [&](const RouteScatter& each) {
            return static_cast<int>(each.route.before.size()) + 1 != waves.n_bounces;
        });
    const std::vector<Reflector> mirrors(target.bodies().size(), perfect_reflector());
    const double wavelength_m = speed_of_light_m_s / frequency_hz;
    const double turn_rad = two_pi / wavelength_m * 2.0 * distance_m;
    return direct_sum(scatter, 0, mirrors, frequency_hz) *
           std::polar(4.0 * pi * distance_m * distance_m / wavelength_m, turn_rad);
}

Complex FarRadar::amplitude_m(const Target& target, const Waves& waves) const {
    const double distance_m = 1e6 * target_size_m;
    return 2.0 * amplitude_from(2.0 * distance_m, target, waves) -
           amplitude_from(distance_m, target, waves);
}

double FarRadar::cross_section_m2(const Target& target, const Waves& waves) const {
    return 4.0 * pi * std::norm(amplitude_m(target, waves));
}

FarRadar monostatic(const FarWave& wave, double frequency_hz, double target_size_m) {
    return {frequency_hz, target_size_m, wave, wave};
}

}  // namespace specula
