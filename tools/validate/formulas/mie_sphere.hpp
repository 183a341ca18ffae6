#pragma once

#include "materials/electrics.hpp"

namespace specula {

/// Back-scattering cross-section of a perfectly conducting sphere over its disc, sigma / (pi a^2).
///
/// Riccati-Bessel functions by their logarithmic derivatives, downward for the regular ones and
/// upward for the others: stable for any size.
/// @in   ka  circumference over wavelength, above 0
/// @eq   Bowman, Senior, Uslenghi 1969, section 10.4; Bohren and Huffman 1983, section 4.8
double conducting_sphere_backscatter(double ka);

/// A homogeneous sphere in air.
struct DielectricSphere {
    double ka;
    Complex refractive_index;  ///< n - j kappa, time exp(+jwt)
};

/// The same of a dielectric one: the series of Mie (1908).
double dielectric_sphere_backscatter(const DielectricSphere& sphere);

}  // namespace specula
