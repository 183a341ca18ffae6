#include "materials/stack.hpp"

#include <algorithm>
#include <cmath>

#include "materials/rough_face.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// A face with a reflection `below` already referred to just beneath it.
Complex joined(Complex r, Complex below, const FaceLoss& loss) {
    const Complex through = (1.0 - r * r) * loss.transmit_twice * below;
    return r * loss.reflect_above + through / (1.0 + r * loss.reflect_below * below);
}

Reflection without_grain(const Stack& stack, double cos_incidence) {
    const double sin_squared = 1.0 - cos_incidence * cos_incidence;
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    const Electrics air;
    const std::size_t n = stack.layers.size();
    const Electrics& last = n > 0 ? stack.layers[n - 1].medium : air;

    const auto* half_space = std::get_if<HalfSpace>(&stack.backing);
    Reflection below = half_space ? fresnel(last, half_space->medium, sin_squared) : pec_reflection;
    const double roughness_m =
        std::visit([](const auto& backing) { return backing.roughness_m; }, stack.backing);
    const auto of_backing = face_loss({last, last, roughness_m}, k, sin_squared);
    below.te *= of_backing.reflect_above;
    below.tm *= of_backing.reflect_above;
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

}  // namespace

bool has_grain(const Stack& stack) {
    return std::any_of(stack.layers.begin(), stack.layers.end(),
                       [](const Layer& layer) { return layer.grain.has_value(); });
}

PrincipalStacks principal_stacks(const Stack& stack) {
    PrincipalStacks principal{stack, stack};
    for (std::size_t i = 0; i < stack.layers.size(); ++i) {
        if (!stack.layers[i].grain) continue;
        principal.along.layers[i].medium = stack.layers[i].grain->along;
        principal.across.layers[i].medium = stack.layers[i].grain->across;
        principal.along.layers[i].grain.reset();
        principal.across.layers[i].grain.reset();
    }
    return principal;
}

Reflection stack_reflection(const Stack& stack, double cos_incidence) {
    SPECULA_EXPECT(cos_incidence > 0.0 && cos_incidence <= 1.0);
    if (!has_grain(stack)) return without_grain(stack, cos_incidence);
    const PrincipalStacks principal = principal_stacks(stack);
    const Reflection along = without_grain(principal.along, cos_incidence);
    const Reflection across = without_grain(principal.across, cos_incidence);
    const double cosine = std::cos(stack.grain_to_field_rad), share = cosine * cosine;
    return {share * along.te + (1.0 - share) * across.te,
            share * along.tm + (1.0 - share) * across.tm};
}

}  // namespace specula
