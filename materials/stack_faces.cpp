#include "materials/stack_faces.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

double roughness_m(const Backing& backing) {
    return std::visit([](const auto& of) { return of.roughness_m; }, backing);
}

FaceUnderWave face_between(const MediumWave& above, const MediumWave& below, double ks) {
    return {.q_above = above.q,
            .q_below = below.q,
            .reflection = fresnel(above, below),
            .loss = face_loss(above, below, ks)};
}

/// A conductor lets no wave in; the losses of its reflection are those seen from above.
FaceUnderWave conductor_under(const MediumWave& above, double ks) {
    return {.q_above = above.q,
            .q_below = 0.0,
            .reflection = pec_reflection,
            .loss = face_loss(above, above, ks)};
}

}  // namespace

FacesUnderWave::FacesUnderWave(const Stack& stack, double cos_incidence)
    : n_(stack.layers.size() + 1) {
    static const Electrics air;
    if (n_ > few_.size()) many_.resize(n_);
    FaceUnderWave* face = many_.empty() ? few_.data() : many_.data();
    const double sin_squared = 1.0 - cos_incidence * cos_incidence;
    const double k = two_pi * stack.frequency_hz / speed_of_light_m_s;
    MediumWave above = wave_in(air, sin_squared);
    for (const Layer& layer : stack.layers) {
        const MediumWave below = wave_in(layer.medium, sin_squared);
        *face = face_between(above, below, k * layer.roughness_m);
        face->pass = std::exp(Complex(0.0, -k * layer.thickness_m) * below.q);
        above = below;
        ++face;
    }
    const double ks = k * roughness_m(stack.backing);
    const auto* half_space = std::get_if<HalfSpace>(&stack.backing);
    *face = half_space ? face_between(above, wave_in(half_space->medium, sin_squared), ks)
                       : conductor_under(above, ks);
}

}  // namespace specula
