#pragma once

#include <string_view>

#include "materials/electrics.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// One relaxation, and the conduction of ions: polar liquids, moist matter.
/// @eq PHYSICS.md#debye; Debye 1929
struct Debye {
    static constexpr std::string_view kind = "debye";
    double static_permittivity = 80.0;
    double high_permittivity = 5.0;  ///< far above the relaxation
    double relaxation_s = 9e-12;
    double conductivity_s_m = 0.0;

    Electrics at(double frequency_hz) const {
        const double omega = two_pi * frequency_hz;
        const Complex relaxing =
            (static_permittivity - high_permittivity) / Complex(1.0, omega * relaxation_s);
        const double ionic = conductivity_s_m / (omega * vacuum_permittivity_f_m);
        return {high_permittivity + relaxing - Complex(0.0, ionic), 1.0};
    }

    /// Keys: high_permittivity >= 1, static_permittivity not below it, relaxation time above 0,
    /// conductivity_s_per_m >= 0 (default 0).
    static Debye read(Section& section) {
        const double high = section.number("high_permittivity", Range::at_least(1.0));
        return {.static_permittivity = section.number("static_permittivity", Range::at_least(high)),
                .high_permittivity = high,
                .relaxation_s = section.quantity("relaxation", Unit::time, Range::above(0.0)),
                .conductivity_s_m = section.quantity("conductivity", Unit::conductivity,
                                                     Range::at_least(0.0), 0.0)};
    }
};

}  // namespace specula
