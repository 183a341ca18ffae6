#include "materials/transmission.hpp"

#include <cmath>

#include "materials/stack_faces.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// What is known of all below a face: the reflection just above it, and the transmission through it
/// and on. TE in E, TM in H.
struct Below {
    Complex reflection;
    Complex transmission;
};

/// A face with a layer under it, on top of `below`.
Below joined(Complex r, const FaceUnderWave& face, const Below& below) {
    const Complex twice = below.reflection * face.pass * face.pass;
    const Complex trips = 1.0 + r * face.loss.reflect_below * twice;
    return {
        r * face.loss.reflect_above + (1.0 - r * r) * face.loss.transmit_twice * twice / trips,
        (1.0 + r) * std::sqrt(face.loss.transmit_twice) * face.pass * below.transmission / trips};
}

/// The last face, into the backing.
Below last_face(Complex r, const FaceLoss& loss) {
    return {r * loss.reflect_above, (1.0 + r) * std::sqrt(loss.transmit_twice)};
}

Transmission ungrained_transmission(const Stack& stack, double cos_incidence) {
    const auto* backing = std::get_if<HalfSpace>(&stack.backing);
    if (backing == nullptr) return {0.0, 0.0};
    const FacesUnderWave under(stack, cos_incidence);
    const std::span<const FaceUnderWave> faces = under.all();
    const FaceUnderWave& bottom = faces.back();
    Below te = last_face(bottom.reflection.te, bottom.loss);
    Below tm = last_face(bottom.reflection.tm, bottom.loss);
    for (std::size_t i = stack.layers.size(); i-- > 0;) {
        const FaceUnderWave& face = faces[i];
        te = joined(face.reflection.te, face, te);
        tm = joined(face.reflection.tm, face, tm);
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
