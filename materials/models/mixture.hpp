#pragma once

#include <string_view>
#include <vector>

#include "materials/electrics.hpp"
#include "materials/ingredient.hpp"
#include "materials/mixing.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// One material finely spread in another: pores, moisture, snow.
/// @eq PHYSICS.md#mixing
/// Limit: grains far smaller than the wavelength in them; at 60 GHz some 0.3 mm.
struct Mixture {
    static constexpr std::string_view kind = "mixture";
    MixingLaw law = MixingLaw::looyenga;
    Ingredient host;
    Ingredient inclusion;
    double inclusion_fraction = 0.0;

    Electrics at(double frequency_hz) const {
        return {mixed_permittivity(law, {.host = host.at(frequency_hz).permittivity,
                                         .inclusion = inclusion.at(frequency_hz).permittivity,
                                         .inclusion_fraction = inclusion_fraction}),
                1.0};
    }
    std::vector<Ingredient> ingredients() const { return {host, inclusion}; }

    /// Keys: host and inclusion, each the name of a material or a table with a model of its own;
    /// volume_fraction of the inclusion in [0, 1]; law (default "looyenga").
    static Mixture read(Section& section, const MaterialLookup& lookup) {
        const std::string law = section.choice(
            "law", {"looyenga", "maxwell_garnett", "bruggeman", "lichtenecker"}, "looyenga");
        return {.law = law == "looyenga"          ? MixingLaw::looyenga
                       : law == "maxwell_garnett" ? MixingLaw::maxwell_garnett
                       : law == "bruggeman"       ? MixingLaw::bruggeman
                                                  : MixingLaw::lichtenecker,
                .host = Ingredient::read(section, "host", lookup),
                .inclusion = Ingredient::read(section, "inclusion", lookup),
                .inclusion_fraction = section.number("volume_fraction", Range::between(0.0, 1.0))};
    }
};

}  // namespace specula
