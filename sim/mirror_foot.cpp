#include "sim/mirror_foot.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

/// Amplitude of an echo from a face of this curvature over that of a flat one, along one axis.
double spread(double curvature_per_m, double range_m) {
    return 1.0 / std::sqrt(std::abs(1.0 + range_m * curvature_per_m));
}

}  // namespace

MirrorFoot mirror_foot(const Pose& pose, const Plate& face, double frequency_hz) {
    const Placement sample = sample_placement(pose);
    const Vector3 radar_m =
        sample.rotation.transpose() * (radar_placement(pose).shift_m - sample.shift_m);
    const double wavelength_m = speed_of_light_m_s / frequency_hz;
    MirrorFoot foot{.x_m = radar_m.x(), .y_m = radar_m.y(), .range_m = radar_m.z()};
    foot.fresnel_radius_m = std::sqrt(0.5 * wavelength_m * std::abs(foot.range_m));
    foot.critical_size_m = 2.0 * std::max(std::abs(foot.x_m), std::abs(foot.y_m));
    const double x_per_m = 8.0 * face.bow_m / (face.size_x_m * face.size_x_m);
    const double y_per_m = 8.0 * face.bow_m / (face.size_y_m * face.size_y_m);
    foot.divergence_db =
        20.0 * std::log10(spread(x_per_m, foot.range_m) * spread(y_per_m, foot.range_m));
    return foot;
}

double MirrorFoot::margin(const Plate& face) const {
    return std::min(0.5 * face.size_x_m - std::abs(x_m), 0.5 * face.size_y_m - std::abs(y_m)) /
           fresnel_radius_m;
}

}  // namespace specula
