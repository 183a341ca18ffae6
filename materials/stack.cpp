#include "materials/stack.hpp"

#include <algorithm>
#include <cmath>

#include "materials/stack_faces.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// A face with a reflection `below` already referred to just beneath it.
Complex joined(Complex r, Complex below, const FaceLoss& loss) {
    const Complex through = (1.0 - r * r) * loss.transmit_twice * below;
    return r * loss.reflect_above + quotient(through, 1.0 + r * loss.reflect_below * below);
}

Reflection without_grain(const Stack& stack, double cos_incidence) {
    const FacesUnderWave under(stack, cos_incidence);
    const std::span<const FaceUnderWave> faces = under.all();
    Reflection below = faces.back().reflection;
    below.te *= faces.back().loss.reflect_above;
    below.tm *= faces.back().loss.reflect_above;
    for (std::size_t i = stack.layers.size(); i-- > 0;) {
        const FaceUnderWave& face = faces[i];
        const Complex twice = face.pass * face.pass;
        below = {joined(face.reflection.te, below.te * twice, face.loss),
                 joined(face.reflection.tm, below.tm * twice, face.loss)};
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
