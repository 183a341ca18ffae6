#pragma once

#include <string_view>

#include "materials/electrics.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// Two relaxations, given by the frequencies at which they are strongest: water and other
/// associating liquids.
/// @eq PHYSICS.md#debye
struct DoubleDebye {
    static constexpr std::string_view kind = "double_debye";
    double static_permittivity = 80.0;
    double middle_permittivity = 5.4;  ///< between the two
    double high_permittivity = 3.5;
    double slow_relaxation_hz = 18e9;
    double fast_relaxation_hz = 720e9;

    Electrics at(double frequency_hz) const {
        const Complex slow = (static_permittivity - middle_permittivity) /
                             Complex(1.0, frequency_hz / slow_relaxation_hz);
        const Complex fast = (middle_permittivity - high_permittivity) /
                             Complex(1.0, frequency_hz / fast_relaxation_hz);
        return {high_permittivity + fast + slow, 1.0};
    }

    /// Keys: high_permittivity >= 1, middle_permittivity and static_permittivity each not below the
    /// one before, slow_relaxation and fast_relaxation frequency, the fast one above the slow one.
    static DoubleDebye read(Section& section) {
        const double high = section.number("high_permittivity", Range::at_least(1.0));
        const double middle = section.number("middle_permittivity", Range::at_least(high));
        const double slow_hz =
            section.quantity("slow_relaxation", Unit::frequency, Range::above(0.0));
        return {
            .static_permittivity = section.number("static_permittivity", Range::at_least(middle)),
            .middle_permittivity = middle,
            .high_permittivity = high,
            .slow_relaxation_hz = slow_hz,
            .fast_relaxation_hz =
                section.quantity("fast_relaxation", Unit::frequency, Range::above(slow_hz))};
    }
};

}  // namespace specula
