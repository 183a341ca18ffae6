#pragma once

#include <string_view>

#include "materials/electrics.hpp"

namespace specula {

/// Two media that fill a volume, in grains much smaller than the wavelength.
struct Mix {
    Complex host;
    Complex inclusion;
    double inclusion_fraction;  ///< of the volume, in [0, 1]
};

enum class MixingLaw { looyenga, maxwell_garnett, bruggeman, lichtenecker };

/// The permittivity that a wave meets on average.
///
/// Looyenga: grains of any shape on equal terms, for powders, pores and moisture. Maxwell Garnett:
/// few spheres in a host that stays connected. Bruggeman: spheres of both media on equal terms.
/// Lichtenecker: mean of the logarithms, an interpolation. For 5 to 15 % of water they differ by a
/// tenth in eps' and a quarter in eps'': the choice is part of the material.
/// @in   mix  Re > 0 and Im <= 0 of both media
/// @out  relative permittivity, Im <= 0; host for fraction 0, inclusion for fraction 1
/// @eq   PHYSICS.md#mixing; Looyenga, Physica 31 (1965) 401; Sihvola 1999 for the others
Complex mixed_permittivity(MixingLaw law, const Mix& mix);

Complex looyenga(const Mix& mix);
Complex maxwell_garnett(const Mix& mix);
Complex bruggeman(const Mix& mix);
Complex lichtenecker(const Mix& mix);

}  // namespace specula
