#pragma once

#include <string>
#include <vector>

#include "materials/library.hpp"

namespace specula {

/// A number that is used at frequencies for which nobody vouches.
struct BandWarning {
    std::string material;  ///< whose number it is; for a mixture perhaps one of its parts
    std::string number;    ///< its key in the file; empty: all of the material
    FrequencyBand valid;
    FrequencyBand used;

    /// "marble: valid from 1 to 60 GHz, used from 57.5 to 61.3 GHz"
    std::string text() const;
};

/// What of a material, of its numbers and of the materials in it does not hold in all of `used`.
std::vector<BandWarning> band_warnings(const Material& material, const FrequencyBand& used);

/// The same for several materials of a library; each warning once. Names that the library does not
/// hold ("air", "metal") are vouched for.
std::vector<BandWarning> band_warnings(const Library& library,
                                       const std::vector<std::string>& names,
                                       const FrequencyBand& used);

}  // namespace specula
