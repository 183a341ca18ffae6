#pragma once

#include "scenes/scene.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// Gaussian heights with correlation exp(-(distance / correlation)^2).
struct Heights {
    double rms_m = 0.0;
    double correlation_m = 1e-3;  ///< > 0
};

/// A plate with one draw of such heights on it, as triangles in the plate's own frame: independent
/// normal numbers on a lattice of at most a fifth of the correlation length, smoothed by
/// exp(-2 r^2 / l^2), whose autocorrelation is the one wanted. Between lattice points the surface
/// is flat, which is 1 % of the rms height.
/// @eq PHYSICS.md#height-field
/// Throws InputError for more than four million triangles.
Mesh height_field(const Plate& plate, const Heights& heights, Stream& piece);

/// The scene with the sample's face as a height field of its piece in place of its roughness; the
/// layers below follow the face. Samples that are smooth or meshes stay as they are.
/// Limit: as a mesh, the sample is opaque unless the scene says otherwise.
Scene with_height_field(const Scene& scene);

}  // namespace specula
