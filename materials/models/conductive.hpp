#pragma once

#include <string_view>

#include "materials/electrics.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// A metal: eps = 1 - j sigma / (w eps0) with a real relative permeability.
struct Conductive {
    static constexpr std::string_view kind = "conductive";
    double conductivity_s_m = 3.5e7;
    double permeability = 1.0;

    Electrics at(double frequency_hz) const {
        const double loss = conductivity_s_m / (two_pi * frequency_hz * vacuum_permittivity_f_m);
        return {Complex(1.0, -loss), permeability};
    }

    /// Keys: conductivity_s_per_m > 0, permeability >= 1.
    static Conductive read(Section& section) {
        return {.conductivity_s_m =
                    section.quantity("conductivity", Unit::conductivity, Range::above(0.0)),
                .permeability = section.number("permeability", Range::between(1.0, 1e4))};
    }
};

}  // namespace specula
