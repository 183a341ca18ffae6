#include "materials/rough_face.hpp"

#include <cmath>

#include "materials/interface.hpp"
#include "sim/core/constants.hpp"

namespace specula {

FaceLoss face_loss(const RoughFace& face, double wavenumber_rad_m, double sin_squared) {
    if (face.roughness_m == 0.0) return {};
    const double ks = wavenumber_rad_m * face.roughness_m;
    const double above = ks * longitudinal_wavenumber(face.above, sin_squared).real();
    const double below = ks * longitudinal_wavenumber(face.below, sin_squared).real();
    return {.reflect_above = std::exp(-2.0 * above * above),
            .reflect_below = std::exp(-2.0 * below * below),
            .transmit_twice = std::exp(-(above - below) * (above - below))};
}

double rayleigh_parameter(const RoughIncidence& incidence) {
    const double k = two_pi * incidence.frequency_hz / speed_of_light_m_s;
    return 2.0 * k * incidence.roughness_m * incidence.cos_incidence;
}

}  // namespace specula
