#include "scenes/antenna.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

double linear(double db) {
    return std::pow(10.0, 0.1 * db);
}

/// The exponent n for which cos^n falls by 6 dB at the given angle.
double exponent_for(double half_width_rad) {
    return std::log(linear(-6.0)) / std::log(std::cos(half_width_rad));
}

}  // namespace

double IsotropicPattern::gain(const Vector3& /*direction*/) const {
    return linear(gain_dbi);
}

IsotropicPattern IsotropicPattern::read(Section& section) {
    return {.gain_dbi = section.quantity("gain", Unit::gain_dbi, Range::between(-30.0, 30.0))};
}

double PatchPattern::gain(const Vector3& direction) const {
    const double forward = -direction.z();
    if (!(forward > 0.0)) return 0.0;
    const double across = std::hypot(direction.x(), forward);  // cos(elevation)
    return linear(gain_dbi) * std::pow(forward / across, exponent_for(half_width_azimuth_rad)) *
           std::pow(across, exponent_for(half_width_elevation_rad));
}

PatchPattern PatchPattern::read(Section& section) {
    const Range angle = Range::inside(0.0, pi / 2.0);
    const PatchPattern patch{
        .gain_dbi = section.quantity("gain", Unit::gain_dbi, Range::between(-30.0, 30.0)),
        .half_width_azimuth_rad = section.quantity("half_width_azimuth", Unit::angle, angle),
        .half_width_elevation_rad = section.quantity("half_width_elevation", Unit::angle, angle)};
    if (const double share = radiated_share(patch); share > largest_radiated_share)
        section.fail_quantity("gain", Unit::gain_dbi,
                              format("radiates {:.3g} times the power it is fed", share),
                              format("at these widths at most {:.4g} dBi is passive",
                                     patch.gain_dbi - 10.0 * std::log10(share)));
    return patch;
}

double gain_towards(const Pattern& pattern, const Vector3& direction) {
    return std::visit([&](const auto& p) { return p.gain(direction); }, pattern);
}

double radiated_share(const Pattern& pattern) {
    constexpr int n_elevations = 90;
    constexpr double step_rad = pi / n_elevations;
    double sum = 0.0;
    for (int e = 0; e < n_elevations; ++e) {
        const double elevation_rad = (e + 0.5) * step_rad - 0.5 * pi;
        const double ring = std::cos(elevation_rad) * step_rad * step_rad;
        for (int a = 0; a < 2 * n_elevations; ++a) {
            const double azimuth_rad = (a + 0.5) * step_rad - pi;
            sum += ring * gain_towards(pattern, {std::cos(elevation_rad) * std::sin(azimuth_rad),
                                                 std::sin(elevation_rad),
                                                 -std::cos(elevation_rad) * std::cos(azimuth_rad)});
        }
    }
    return sum / (4.0 * pi);
}

Vector3 field_pattern(const Pattern& pattern, const Vector3& direction) {
    const Vector3 transverse = Vector3::UnitY() - direction.y() * direction;
    const double length = transverse.norm();
    if (length == 0.0) return Vector3::Zero();
    return transverse * (std::sqrt(gain_towards(pattern, direction)) / length);
}

FieldPattern::FieldPattern(const Pattern& pattern, const Rotation& rotation)
    : pattern_(pattern), x_(rotation.col(0)), y_(rotation.col(1)), z_(rotation.col(2)) {
    const auto* patch = std::get_if<PatchPattern>(&pattern);
    if (!patch) return;
    root_peak_ = std::sqrt(linear(patch->gain_dbi));
    azimuth_exponent_ = exponent_for(patch->half_width_azimuth_rad);
    elevation_exponent_ = exponent_for(patch->half_width_elevation_rad);
}

double FieldPattern::root_gain(const Vector3& direction) const {
    if (!std::holds_alternative<PatchPattern>(pattern_))
        return std::sqrt(gain_towards(pattern_, direction));
    const double forward = -direction.z();
    if (!(forward > 0.0)) return 0.0;
    const double log_across = 0.5 * std::log(direction.x() * direction.x() + forward * forward);
    return root_peak_ * std::exp(0.5 * (azimuth_exponent_ * (std::log(forward) - log_across) +
                                        elevation_exponent_ * log_across));
}

Vector3 FieldPattern::operator()(const Vector3& direction) const {
    const double along_y = direction.dot(y_);
    const Vector3 transverse = y_ - along_y * direction;
    const double length = transverse.norm();
    if (length == 0.0) return Vector3::Zero();
    return transverse * (root_gain({direction.dot(x_), along_y, direction.dot(z_)}) / length);
}

}  // namespace specula
