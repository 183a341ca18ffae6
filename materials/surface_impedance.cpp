#include "materials/surface_impedance.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

SurfaceImpedance::SurfaceImpedance(const Conductive& metal, double frequency_hz)
    : skin_depth_m_(std::sqrt(2.0 / (two_pi * frequency_hz * vacuum_permeability_h_m *
                                     metal.permeability * metal.conductivity_s_m))),
      resistance_ohm_(1.0 / (metal.conductivity_s_m * skin_depth_m_)) {}

Reflection SurfaceImpedance::reflection(double cos_incidence) const {
    const Complex z = ohm() / vacuum_impedance_ohm;
    return {(z * cos_incidence - 1.0) / (z * cos_incidence + 1.0),
            (cos_incidence - z) / (cos_incidence + z)};
}

double penetration_depth_m(const Electrics& medium, double frequency_hz) {
    const double k = two_pi * frequency_hz / speed_of_light_m_s;
    return 1.0 / (k * std::abs(longitudinal_wavenumber(medium, 0.0).imag()));
}

}  // namespace specula
