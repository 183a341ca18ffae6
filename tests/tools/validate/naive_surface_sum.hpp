#pragma once

#include <cmath>
#include <complex>
#include <functional>

#include "scenes/vector3.hpp"
#include "sim/core/constants.hpp"

namespace specula {

/// Physical optics of a conductor as it is written down, by the midpoint rule: for tests to hold
/// the simulator against.
struct NaivePlate {
    double side_m;
    double height_m;
    double frequency_hz;
    double about_x_rad = 0.0, about_y_rad = 0.0;  ///< about the plate's centre
    Vector3 centre_m = Vector3::Zero();
    Vector3 tx_m = Vector3::Zero(), rx_m = Vector3::Zero();  ///< beside the axis
    bool tx_is_patch = false, rx_is_patch = false;
    double sag_m = 0.0;

    std::complex<double> transfer(int n = 240) const;
};

/// 5.5 dBi, 6 dB down at 60 degrees of azimuth and 35 of elevation; or isotropic.
inline Vector3 naive_field(bool is_patch, const Vector3& d) {
    const Vector3 across = (Vector3::UnitY() - d.y() * d).normalized();
    if (!is_patch) return across;
    const double down = std::log(std::pow(10.0, -0.6));
    const double azimuth =
        std::pow(std::cos(std::atan2(d.x(), -d.z())), down / std::log(std::cos(pi / 3.0)));
    const double elevation =
        std::pow(std::cos(std::asin(d.y())), down / std::log(std::cos(35.0 * pi / 180.0)));
    return std::sqrt(std::pow(10.0, 0.55) * azimuth * elevation) * across;
}

inline std::complex<double> NaivePlate::transfer(int n) const {
    const Vector3 tx = tx_m + height_m * Vector3::UnitZ(), rx = rx_m + height_m * Vector3::UnitZ();
    const double cx = std::cos(about_x_rad), sx = std::sin(about_x_rad);
    const double cy = std::cos(about_y_rad), sy = std::sin(about_y_rad);
    const auto tilted = [&](const Vector3& p) {
        const Vector3 q(p.x(), cx * p.y() - sx * p.z(), sx * p.y() + cx * p.z());
        return Vector3(cy * q.x() + sy * q.z(), q.y(), -sy * q.x() + cy * q.z());
    };
    const double k = two_pi * frequency_hz / 299792458.0, step = side_m / n;
    const double curve = 4.0 * sag_m / (side_m * side_m);
    std::complex<double> sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double x = (i + 0.5) * step - 0.5 * side_m, y = (j + 0.5) * step - 0.5 * side_m;
            const Vector3 p = centre_m + tilted({x, y, -curve * (x * x + y * y)});
            const Vector3 normal_area = tilted({2.0 * curve * x, 2.0 * curve * y, 1.0});
            const double r1 = (p - tx).norm(), r2 = (rx - p).norm();
            const Vector3 in = (p - tx) / r1, out = (rx - p) / r2;
            const Vector3 current = 2.0 * normal_area.cross(in.cross(naive_field(tx_is_patch, in)));
            sum += (current - out * out.dot(current)).dot(naive_field(rx_is_patch, -out)) /
                   (r1 * r2) * std::polar(step * step, -k * (r1 + r2));
        }
    }
    const double wavelength = 299792458.0 / frequency_hz;
    return wavelength / (4.0 * pi) * std::complex<double>(0.0, -k / (4.0 * pi)) * sum;
}

}  // namespace specula
