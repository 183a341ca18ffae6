#include "tools/validate/formulas/radar_equation.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

double edge_to_fourth_over_wavelength_squared(const CornerReflector& corner) {
    const double wavelength_m = speed_of_light_m_s / corner.frequency_hz;
    return std::pow(corner.edge_m, 4) / (wavelength_m * wavelength_m);
}

}  // namespace

double received_dbm(const RadarEquation& target) {
    const double wavelength_m = speed_of_light_m_s / target.frequency_hz;
    const double ratio = wavelength_m * wavelength_m * target.cross_section_m2 /
                         (std::pow(4.0 * pi, 3) * std::pow(target.range_m, 4));
    return target.transmitted_dbm + target.two_way_gain_db + 10.0 * std::log10(ratio);
}

double sphere_cross_section_m2(double radius_m) {
    return pi * radius_m * radius_m;
}

double triangular_trihedral_m2(const CornerReflector& corner) {
    return 4.0 * pi / 3.0 * edge_to_fourth_over_wavelength_squared(corner);
}

double square_trihedral_m2(const CornerReflector& corner) {
    return 12.0 * pi * edge_to_fourth_over_wavelength_squared(corner);
}

}  // namespace specula
