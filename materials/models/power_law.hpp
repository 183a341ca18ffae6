#pragma once

#include <cmath>
#include <string_view>

#include "materials/electrics.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// eps' = a f^b and sigma = c f^d with f in GHz: the building materials of ITU-R P.2040.
/// @eq ITU-R P.2040-3, equations (28) and (29), table 3
struct PowerLaw {
    static constexpr std::string_view kind = "power_law";
    double a = 1.99, b = 0.0, c = 0.0047, d = 1.0718;

    Electrics at(double frequency_hz) const {
        const double f_ghz = frequency_hz * 1e-9;
        const double sigma_s_m = c * std::pow(f_ghz, d);
        const double loss = sigma_s_m / (two_pi * frequency_hz * vacuum_permittivity_f_m);
        return {Complex(a * std::pow(f_ghz, b), -loss), 1.0};
    }

    /// Keys: a > 0, b, c >= 0 (S/m at 1 GHz), d.
    static PowerLaw read(Section& section) {
        return {.a = section.number("a", Range::above(0.0)),
                .b = section.number("b", Range::between(-5.0, 5.0)),
                .c = section.number("c", Range::at_least(0.0)),
                .d = section.number("d", Range::between(-5.0, 5.0))};
    }
};

}  // namespace specula
