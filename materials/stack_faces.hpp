#pragma once

#include <vector>

#include "materials/rough_face.hpp"
#include "materials/stack.hpp"

namespace specula {

/// A face of a stack under a wave: what it does by itself, and the way to the next one.
struct FaceUnderWave {
    Complex q_above;         ///< normalised longitudinal wave number in the medium above
    Complex q_below;         ///< 0 in a conductor
    Reflection reflection;   ///< Fresnel's
    FaceLoss loss;           ///< coherent losses by the face's heights
    Complex pass{1.0, 0.0};  ///< phase and loss of one way through the layer beneath
};

/// All faces of a stack, the one towards the radar first, with every wave number, Fresnel
/// coefficient and round trip worked out once. A grain is not looked at.
/// @in   cos_incidence  in (0, 1], in air
/// @eq   PHYSICS.md#fresnel, PHYSICS.md#coherent-roughness
std::vector<FaceUnderWave> faces_under_wave(const Stack& stack, double cos_incidence);

}  // namespace specula
