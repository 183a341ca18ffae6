#include "sim/trace/patch.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr int extra_points = 8;
constexpr int looks_per_axis = 9;

/// Rate of the path TX-point-RX along the face's x and y, in metres per metre.
struct PathRate {
    double along_x;
    double along_y;
};

PathRate path_rate(const PlateView& view, const AntennaPair& pair, double x_m, double y_m) {
    const Plate& plate = view.plate;
    const Vector3 point = view.plate_placement.point({x_m, y_m, plate.height_m(x_m, y_m)});
    const Vector3 pull = (point - pair.tx_m).normalized() + (point - pair.rx_m).normalized();
    const Vector3 normal = plate.area_normal(x_m, y_m);
    const Vector3 step_x = view.plate_placement.direction({1.0, 0.0, -normal.x()});
    const Vector3 step_y = view.plate_placement.direction({0.0, 1.0, -normal.y()});
    return {pull.dot(step_x), pull.dot(step_y)};
}

}  // namespace

PointCount points_needed(const PlateView& view, const AntennaPair& pair, const Patch& patch,
                         double wavelength_m) {
    const double half_x_m = 0.5 * (patch.x_m[1] - patch.x_m[0]);
    const double half_y_m = 0.5 * (patch.y_m[1] - patch.y_m[0]);
    double turns_x = 0.0, turns_y = 0.0;  // per unit of u or v, weighted by the nodes' spacing
    for (int i = 0; i < looks_per_axis; ++i) {
        for (int j = 0; j < looks_per_axis; ++j) {
            const double u = -1.0 + 2.0 * i / (looks_per_axis - 1);
            const double v = -1.0 + 2.0 * j / (looks_per_axis - 1);
            const PathRate rate = path_rate(view, pair, patch.x_at(u), patch.y_at(v));
            turns_x = std::max(turns_x, std::abs(rate.along_x) * std::sqrt(1.0 - u * u));
            turns_y = std::max(turns_y, std::abs(rate.along_y) * std::sqrt(1.0 - v * v));
        }
    }
    turns_x *= half_x_m / wavelength_m;
    turns_y *= half_y_m / wavelength_m;
    return {static_cast<int>(std::ceil(two_pi * turns_x)) + extra_points,
            static_cast<int>(std::ceil(two_pi * turns_y)) + extra_points};
}

}  // namespace specula
