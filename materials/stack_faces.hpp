#pragma once

#include <array>
#include <span>
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
/// @eq   PHYSICS.md#fresnel, PHYSICS.md#coherent-roughness
class FacesUnderWave {
  public:
    /// @in   cos_incidence  in (0, 1], in air
    FacesUnderWave(const Stack& stack, double cos_incidence);

    std::span<const FaceUnderWave> all() const {
        return many_.empty() ? std::span<const FaceUnderWave>(few_).first(n_) : many_;
    }

  private:
    std::size_t n_;
    std::array<FaceUnderWave, 4> few_;  ///< no memory is asked for where these do
    std::vector<FaceUnderWave> many_;
};

}  // namespace specula
