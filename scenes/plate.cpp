#include "scenes/plate.hpp"

namespace specula {

double Plate::height_m(double x_m, double y_m) const {
    const double u = 2.0 * x_m / size_x_m, v = 2.0 * y_m / size_y_m;
    return -bow_m * (u * u + v * v);
}

Vector3 Plate::area_normal(double x_m, double y_m) const {
    const double slope_x = -8.0 * bow_m * x_m / (size_x_m * size_x_m);
    const double slope_y = -8.0 * bow_m * y_m / (size_y_m * size_y_m);
    return {-slope_x, -slope_y, 1.0};
}

}  // namespace specula
