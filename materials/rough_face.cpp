#include "materials/rough_face.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

FaceLoss face_loss(const MediumWave& above, const MediumWave& below, double ks) {
    if (ks == 0.0) return {};
    const double over = ks * above.q.real(), under = ks * below.q.real();
    return {.reflect_above = std::exp(-2.0 * over * over),
            .reflect_below = std::exp(-2.0 * under * under),
            .transmit_twice = std::exp(-(over - under) * (over - under))};
}

FaceLoss face_loss(const RoughFace& face, double wavenumber_rad_m, double sin_squared) {
    return face_loss(wave_in(face.above, sin_squared), wave_in(face.below, sin_squared),
                     wavenumber_rad_m * face.roughness_m);
}

double rayleigh_parameter(const RoughIncidence& incidence) {
    const double k = two_pi * incidence.frequency_hz / speed_of_light_m_s;
    return 2.0 * k * incidence.roughness_m * incidence.cos_incidence;
}

}  // namespace specula
