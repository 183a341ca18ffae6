#pragma once

#include "materials/stack.hpp"

namespace specula {

/// Field transmission of the two polarisations, E field over E field, both of one sign at normal
/// incidence. In a medium the amplitude of a TM wave is that of its H field times the impedance.
struct Transmission {
    Complex te{1.0, 0.0};
    Complex tm{1.0, 0.0};
};

/// Coherent field behind a stack, just inside its backing, over the incident field at its uppermost
/// face. The companion of `stack_reflection`; a perfect conductor lets nothing through.
/// @in   cos_incidence in (0, 1], in air
/// @eq   PHYSICS.md#transmission
/// Limit: that of `stack_reflection`.
Transmission stack_transmission(const Stack& stack, double cos_incidence);

/// Where the power of a wave goes, as shares of what falls on the stack; each in [0, 1], sum 1.
struct PowerShares {
    double reflected;
    double transmitted;  ///< through the last face, into the backing
    double absorbed;     ///< in the layers, and what rough faces scatter
};
struct StackPower {
    PowerShares te;
    PowerShares tm;
};
/// @eq PHYSICS.md#energy
StackPower stack_power(const Stack& stack, double cos_incidence);

}  // namespace specula
