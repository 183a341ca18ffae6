#pragma once

#include "materials/stack.hpp"

namespace specula {

/// A face of a stack: 0 is the one towards the radar, the last one that of the backing.
struct StackFace {
    int number = 0;
    double roughness_m = 0.0;     ///< rms of Gaussian heights
    double correlation_m = 1e-3;  ///< their correlation is exp(-(distance / correlation)^2)
};

/// Faces of a stack from the top, the smooth ones too: one more than it has layers.
int n_faces(const Stack& stack);
StackFace face_of(const Stack& stack, int number);

/// What a rough face adds to the reflection of its stack around the coherent part, as a spectrum:
/// the field reflection fluctuates over the face by u(x) with E[u] = 0, and |te|^2 is the integral
/// of E[u(x) u*(x + d)] exp(-jK.d) over d at K = 2 k sin(angle), that is, for scattering back to
/// where the wave came from. The phase is that of the echo as it changes with frequency.
///
/// The heights of the face modulate every wave that it reflects or lets through, each in the order
/// n of its Hermite series; order n has the correlation to the power of n. For a single face this
/// is Kirchhoff's series. What happens above the face, coherent losses included, is in it.
/// @in   cos_incidence  in air, in (0, 1]; between the directions to TX and RX where they differ
/// @out  metre; 0 for a smooth face
/// @eq   PHYSICS.md#diffuse-roughness; Beckmann and Spizzichino 1963; Ulaby, Moore, Fung vol. 2
/// Limit: slopes below 0.3, correlation longer than half a wavelength in the upper medium, no
/// shadows between heights; the phase 2 k q s below 35 rad.
Reflection diffuse_reflection(const Stack& stack, const StackFace& face, double cos_incidence);

/// Power of the diffuse echo over that of a perfect mirror at the same height: what a face of at
/// most the width of its height sends back when every point of it scatters as it does head-on.
/// @eq PHYSICS.md#diffuse-level
double diffuse_over_mirror(const Stack& stack, const StackFace& face);

}  // namespace specula
