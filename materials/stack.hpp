#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "materials/grain.hpp"
#include "materials/interface.hpp"

namespace specula {

/// A layer at one frequency, and the face towards the radar.
struct Layer {
    Electrics medium;
    double thickness_m = 0.0;                     ///< > 0
    double roughness_m = 0.0;                     ///< rms height of the upper face, >= 0
    std::optional<Grained> grain = std::nullopt;  ///< used in place of `medium` where it has one
    double correlation_m = 1e-3;                  ///< > 0, of the upper face's heights
};

/// What ends a stack below: nothing but air, a half-space, or a perfect conductor.
struct PerfectConductor {
    double roughness_m = 0.0;
    double correlation_m = 1e-3;
};
struct HalfSpace {
    Electrics medium;
    double roughness_m = 0.0;
    double correlation_m = 1e-3;
};
using Backing = std::variant<HalfSpace, PerfectConductor>;

/// Layers at one frequency, the one facing the radar first.
struct Stack {
    std::vector<Layer> layers{};
    Backing backing = HalfSpace{};
    double frequency_hz = 0.0;
    /// From the grain to the electric field, in the plane of the face; without a grain unused.
    double grain_to_field_rad = 0.0;
};

/// Coherent field reflection of a stack in air, referred to its uppermost face.
///
/// All internal round trips in closed form, from the backing upwards. Roughness lowers the coherent
/// coefficients of each face by Gaussian phase averaging: reflection by exp(-2 (k q s)^2) seen from
/// either side, transmission by exp(-(k s (q1 - q2))^2 / 2) per pass. With a grain: what comes back
/// in the polarisation that was sent, cos^2 of the reflection along the grain and sin^2 across.
/// @in   cos_incidence in (0, 1], in air
/// @out  |te|, |tm| <= 1
/// @eq   PHYSICS.md#stack; Parratt 1954 recursion; PHYSICS.md#coherent-roughness; Ament 1953;
///       PHYSICS.md#grain
/// Limit: faces parallel and wide; the diffuse part of rough faces is in materials/diffuse.hpp. A
/// grain is exact at normal incidence; what it turns into the other polarisation is not in here.
Reflection stack_reflection(const Stack& stack, double cos_incidence);

/// The layers as a field along the grain meets them, and as one across does; neither has a grain.
struct PrincipalStacks {
    Stack along;
    Stack across;
};
bool has_grain(const Stack& stack);
PrincipalStacks principal_stacks(const Stack& stack);

}  // namespace specula
