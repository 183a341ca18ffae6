#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "materials/electrics.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// Relaxations that are spread out, and the conduction of ions: tissue.
/// @eq PHYSICS.md#cole-cole; S. Gabriel, Lau, C. Gabriel, Phys. Med. Biol. 41 (1996) 2271
struct ColeCole {
    static constexpr std::string_view kind = "cole_cole";

    struct Pole {
        double strength;      ///< of the permittivity, > 0
        double relaxation_s;  ///< > 0
        double spread;        ///< alpha in [0, 1); 0 is Debye's
    };
    double high_permittivity = 4.0;
    std::vector<Pole> poles;
    double conductivity_s_m = 0.0;

    Electrics at(double frequency_hz) const {
        const double omega = two_pi * frequency_hz;
        Complex permittivity(high_permittivity,
                             -conductivity_s_m / (omega * vacuum_permittivity_f_m));
        for (const Pole& pole : poles) {
            const double order = 1.0 - pole.spread;
            const Complex turned = std::polar(std::pow(omega * pole.relaxation_s, order),
                                              0.5 * pi * order);  // (jwt)^(1-alpha)
            permittivity += pole.strength / (1.0 + turned);
        }
        return {permittivity, 1.0};
    }

    /// Keys: high_permittivity >= 1, conductivity_s_per_m >= 0 (default 0), and one to eight
    /// [[pole]] with strength, relaxation time and spread (default 0).
    static ColeCole read(Section& section) {
        ColeCole model{
            .high_permittivity = section.number("high_permittivity", Range::at_least(1.0)),
            .poles = {},
            .conductivity_s_m =
                section.quantity("conductivity", Unit::conductivity, Range::at_least(0.0), 0.0)};
        for (Section& pole : section.sections("pole")) {
            model.poles.push_back(
                {.strength = pole.number("strength", Range::above(0.0)),
                 .relaxation_s = pole.quantity("relaxation", Unit::time, Range::above(0.0)),
                 .spread = pole.number("spread",
                                       Range{.min = 0.0, .max = 1.0, .max_excluded = true}, 0.0)});
            pole.finish();
        }
        if (model.poles.empty() || model.poles.size() > 8)
            section.fail("pole", "not one to eight relaxations", "describe each as [[pole]]");
        return model;
    }
};

}  // namespace specula
