#pragma once

#include <cstdint>

#include "sim/core/random.hpp"
#include "sim/trace/placed_antenna.hpp"
#include "sim/trace/scatter.hpp"
#include "sim/trace/target.hpp"

namespace specula {

/// A rough face: Gaussian heights, Gaussian correlation exp(-(distance / correlation)^2).
struct RoughFace {
    Plate plate;
    Placement placement;
    double rms_m = 0.0;
    double correlation_m = 1e-3;  ///< > 0
};

/// Diffuse power per solid angle and area over |R|^2: sigma0 / |R|^2 of the Kirchhoff series,
///
/// sigma0 = (k^2/2) (4 |R|^2 / cos^2) e^{-x} Sum_n x^n / n! W_n,   x = (2 k s cos)^2,
/// W_n = (l^2 / 2n) exp(-(2 k l sin)^2 / 4n).
/// @in  cos_incidence in (0, 1]
/// @eq  PHYSICS.md#diffuse-roughness; Beckmann and Spizzichino 1963; Ulaby, Moore, Fung vol. 2, ch. 12
/// Limit: correlation longer than half a wavelength, slopes below 0.3, no shadowing between heights.
double diffuse_cross_section(const RoughFace& face, double cos_incidence, double frequency_hz);

/// Adds the diffuse echo of a rough face as points of their own: cells of the face no smaller than
/// the correlation length, each with a complex Gaussian amplitude that belongs to the piece. Moving
/// the piece turns the cells against each other, which is what decorrelates speckle; standing still
/// does not.
///
/// The amplitude's phase is taken as a length at `frequency_hz`, the middle of the band.
/// @in  smooth_body  body whose reflector has no roughness, for |R|
void add_speckle(Scatter& scatter, const Target& target, const RoughFace& face,
                 const AntennaSet& antennas, double frequency_hz, int smooth_body, Stream& piece);

}  // namespace specula
