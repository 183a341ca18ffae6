#pragma once

#include <string_view>

#include "materials/electrics.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// The same complex permittivity over the whole valid band: low-loss plastics and dry stone.
struct Constant {
    static constexpr std::string_view kind = "constant";
    Complex permittivity{2.6, -0.026};

    Electrics at(double /*frequency_hz*/) const { return {permittivity, 1.0}; }

    /// Keys: permittivity (real part >= 1), loss_tangent >= 0.
    static Constant read(Section& section) {
        const double real = section.number("permittivity", Range::at_least(1.0));
        const double loss_tangent = section.number("loss_tangent", Range::between(0.0, 10.0));
        return {.permittivity = {real, -real * loss_tangent}};
    }
};

}  // namespace specula
