#pragma once

#include <string_view>

#include "materials/electrics.hpp"
#include "materials/models/double_debye.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// Liquid fresh water at a temperature, up to 1 THz.
/// @eq PHYSICS.md#water; Liebe, Hufford, Manabe, Int. J. IR MM Waves 12 (1991) 659; ITU-R P.840-8
/// Limit: fitted between 0 and 30 degrees Celsius; salts are left out.
struct Water {
    static constexpr std::string_view kind = "water";
    double temperature_k = 293.15;

    DoubleDebye relaxations() const {
        const double colder = 300.0 / temperature_k - 1.0;
        const double e0 = 77.66 + 103.3 * colder;
        const double slow_ghz = 20.20 + colder * (-146.0 + 316.0 * colder);
        return {.static_permittivity = e0,
                .middle_permittivity = 0.0671 * e0,
                .high_permittivity = 3.52,
                .slow_relaxation_hz = slow_ghz * 1e9,
                .fast_relaxation_hz = 39.8 * slow_ghz * 1e9};
    }
    Electrics at(double frequency_hz) const { return relaxations().at(frequency_hz); }

    /// Keys: temperature_k, -20 to 60 degrees Celsius (default 20).
    static Water read(Section& section) {
        return {.temperature_k = section.quantity("temperature", Unit::temperature,
                                                  Range::between(253.15, 333.15), 293.15)};
    }
};

}  // namespace specula
