#pragma once

#include <optional>
#include <vector>

#include "materials/electrics.hpp"

namespace specula {

/// A dipole that lies above an infinite plane stack, and hears its own echo.
struct DipoleOverPlane {
    double frequency_hz;
    double height_m;
    struct PlaneLayer {
        Complex permittivity;
        double thickness_m;
    };
    std::vector<PlaneLayer> layers;  ///< the one facing the dipole first
    std::optional<Complex> backing;  ///< relative permittivity below; none: a perfect conductor
};

/// Channel of the horizontal dipole to itself over its gain, exactly.
///
/// Sommerfeld's integral over all plane waves, real and evanescent, of their reflections; the path
/// is turned from the real axis to the line kz = k (1 - jt), along which the integrand falls as
/// exp(-2ktH). Nothing lies between the two paths: surface and guided waves of passive stacks have
/// Re kz <= 0. Independent of the reflection code of materials/, which knows real angles only.
/// @out  h over the dipole's gain of 1.5
/// @eq   Chew, Waves and Fields in Inhomogeneous Media (1995), section 2.3
/// Limit: heights above a tenth of a wavelength.
Complex dipole_over_plane(const DipoleOverPlane& dipole);

/// What an isotropic antenna would see of the plane if it were its mirror image times the
/// reflection at normal incidence: h = lambda G r / (4 pi 2H) exp(-2jkH).
struct ImageSource {
    double frequency_hz;
    double height_m;
    double gain;         ///< linear
    Complex reflection;  ///< r_TE at normal incidence
};
Complex image_source(const ImageSource& image);

}  // namespace specula
