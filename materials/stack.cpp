#include "materials/stack.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

struct Face {
    const Electrics& above;
    const Electrics& below;
    double roughness_m;
};

/// The factors by which a rough face lowers its coherent coefficients.
struct FaceLoss {
    double reflect_above = 1.0;
    double reflect_below = 1.0;
    double transmit_twice = 1.0;
};

FaceLoss face_loss(const Face& face, double wavenumber_rad_m, double sin_squared) {
    if (face.roughness_m == 0.0) return {};
    const double ks = wavenumber_rad_m * face.roughness_m;
    const double above = ks * longitudinal_wavenumber(face.above, sin_squared).real();
    const double below = ks * longitudinal_wavenumber(face.below, sin_squared).real();
    return {.reflect_above = std::exp(-2.0 * above * above),
            .reflect_below = std::exp(-2.0 * below * below),
            .transmit_twice = std::exp(-(above - below) * (above - below))};
}

/// A face with a reflection `below` already referred to just beneath it.
Complex joined(Complex r, Complex below, const FaceLoss& loss) {
    const Complex through = (1.0 - r * r) * loss.transmit_twice * below;
    return r * loss.reflect_above + through / (1.0 + r * loss.reflect_below * below);
}

}  // namespace

Reflection stack_reflection(const Stack& stack, double cos_incidence) {
    SPECULA_EXPECT(cos_incidence > 0.0 && cos_incidence <= 1.0);
    const double sin_squared = 1.0 - cos_incidence * cos_incidence;
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    const Electrics air;
    const std::size_t n = stack.layers.size();
    const Electrics& last = n > 0 ? stack.layers[n - 1].medium : air;

    Reflection below = pec_reflection;
    if (const auto* half_space = std::get_if<HalfSpace>(&stack.backing)) {
        below = fresnel(last, half_space->medium, sin_squared);
        const auto loss =
            face_loss({last, half_space->medium, half_space->roughness_m}, k, sin_squared);
        below.te *= loss.reflect_above;
        below.tm *= loss.reflect_above;
    }
    for (std::size_t i = n; i-- > 0;) {
        const Layer& layer = stack.layers[i];
        const Electrics& above = i > 0 ? stack.layers[i - 1].medium : air;
        const Complex q = longitudinal_wavenumber(layer.medium, sin_squared);
        const Complex twice = std::exp(Complex(0.0, -2.0 * k * layer.thickness_m) * q);
        const Reflection face = fresnel(above, layer.medium, sin_squared);
        const auto loss = face_loss({above, layer.medium, layer.roughness_m}, k, sin_squared);
        below = {joined(face.te, below.te * twice, loss), joined(face.tm, below.tm * twice, loss)};
    }
    return below;
}

}  // namespace specula
