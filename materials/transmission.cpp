#include "materials/transmission.hpp"

#include <cmath>

#include "materials/rough_face.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// What is known of all below a face: the reflection just above it, and the transmission through it
/// and on. TE in E, TM in H.
struct Below {
    Complex reflection;
    Complex transmission;
};

/// A layer of one-way phase factor `phase` on top of `below`, under a face of coefficient `r`.
Below joined(Complex r, const FaceLoss& loss, Complex phase, const Below& below) {
    const Complex twice = below.reflection * phase * phase;
    const Complex trips = 1.0 + r * loss.reflect_below * twice;
    return {r * loss.reflect_above + (1.0 - r * r) * loss.transmit_twice * twice / trips,
            (1.0 + r) * std::sqrt(loss.transmit_twice) * phase * below.transmission / trips};
}

/// The last face, into the backing.
Below last_face(Complex r, const FaceLoss& loss) {
    return {r * loss.reflect_above, (1.0 + r) * std::sqrt(loss.transmit_twice)};
}

Transmission ungrained_transmission(const Stack& stack, double cos_incidence) {
    const auto* backing = std::get_if<HalfSpace>(&stack.backing);
    if (backing == nullptr) return {0.0, 0.0};
    const double sin_squared = 1.0 - cos_incidence * cos_incidence;
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    const Electrics air;
    const std::size_t n = stack.layers.size();
    const Electrics& last = n > 0 ? stack.layers[n - 1].medium : air;

    const Reflection bottom = fresnel(last, backing->medium, sin_squared);
    const FaceLoss loss = face_loss({last, backing->medium, backing->roughness_m}, k, sin_squared);
    Below te = last_face(bottom.te, loss), tm = last_face(bottom.tm, loss);
    for (std::size_t i = n; i-- > 0;) {
        const Layer& layer = stack.layers[i];
        const Electrics& above = i > 0 ? stack.layers[i - 1].medium : air;
        const Complex q = longitudinal_wavenumber(layer.medium, sin_squared);
        const Complex phase = std::exp(Complex(0.0, -k * layer.thickness_m) * q);
        const Reflection face = fresnel(above, layer.medium, sin_squared);
        const FaceLoss here = face_loss({above, layer.medium, layer.roughness_m}, k, sin_squared);
        te = joined(face.te, here, phase, te);
        tm = joined(face.tm, here, phase, tm);
    }
    const Complex impedance =
        std::sqrt(backing->medium.permeability / backing->medium.permittivity);
    return {te.transmission, impedance * tm.transmission};
}

PowerShares shares(Complex reflection, double transmitted) {
    const double reflected = std::norm(reflection);
    return {reflected, transmitted, 1.0 - reflected - transmitted};
}

/// Half the power turns away where the grain is oblique to the field, so shares are averaged, not
/// fields.
PowerShares mean(double share, const PowerShares& along, const PowerShares& across) {
    const auto mix = [&](double a, double b) { return share * a + (1.0 - share) * b; };
    return {mix(along.reflected, across.reflected), mix(along.transmitted, across.transmitted),
            mix(along.absorbed, across.absorbed)};
}

StackPower power_without_grain(const Stack& stack, double cos_incidence) {
    const Reflection r = stack_reflection(stack, cos_incidence);
    const auto* backing = std::get_if<HalfSpace>(&stack.backing);
    if (backing == nullptr) return {shares(r.te, 0.0), shares(r.tm, 0.0)};
    const Transmission t = ungrained_transmission(stack, cos_incidence);
    const auto& [permittivity, permeability] = backing->medium;
    const Complex q = longitudinal_wavenumber(backing->medium, 1.0 - cos_incidence * cos_incidence);
    const double te = (q / permeability).real() / cos_incidence;
    const double tm =
        (q / permittivity).real() / cos_incidence * std::abs(permittivity / permeability);
    return {shares(r.te, te * std::norm(t.te)), shares(r.tm, tm * std::norm(t.tm))};
}

double share_along(const Stack& stack) {
    const double cosine = std::cos(stack.grain_to_field_rad);
    return cosine * cosine;
}

}  // namespace

Transmission stack_transmission(const Stack& stack, double cos_incidence) {
    SPECULA_EXPECT(cos_incidence > 0.0 && cos_incidence <= 1.0);
    if (!has_grain(stack)) return ungrained_transmission(stack, cos_incidence);
    const PrincipalStacks principal = principal_stacks(stack);
    const Transmission along = ungrained_transmission(principal.along, cos_incidence);
    const Transmission across = ungrained_transmission(principal.across, cos_incidence);
    const double share = share_along(stack);
    return {share * along.te + (1.0 - share) * across.te,
            share * along.tm + (1.0 - share) * across.tm};
}

StackPower stack_power(const Stack& stack, double cos_incidence) {
    if (!has_grain(stack)) return power_without_grain(stack, cos_incidence);
    const PrincipalStacks principal = principal_stacks(stack);
    const StackPower along = power_without_grain(principal.along, cos_incidence);
    const StackPower across = power_without_grain(principal.across, cos_incidence);
    const double share = share_along(stack);
    return {mean(share, along.te, across.te), mean(share, along.tm, across.tm)};
}

}  // namespace specula
