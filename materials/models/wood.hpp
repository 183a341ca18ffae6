#pragma once

#include <algorithm>
#include <string_view>

#include "materials/electrics.hpp"
#include "materials/grain.hpp"
#include "materials/mixing.hpp"
#include "materials/models/water.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// Wood from its density and moisture, along and across the grain.
///
/// Walls of one substance and pores of air: side by side for a field along the grain (parallel
/// capacitors), Lichtenecker's mean across it, the same radially and tangentially. Water up to
/// fibre saturation swells the walls and is bound; what is more fills the pores. Both by Looyenga.
/// @eq PHYSICS.md#wood; J. Wood Sci. 59 (2013), 10.1007/s10086-013-1341-7, nine species at 100 GHz
/// Limit: 30 to 120 GHz; the permittivities of wall and bound water are estimates; growth rings are
/// left out.
struct Wood {
    static constexpr std::string_view kind = "wood";
    static constexpr double wall_density_kg_m3 = 1500.0;
    static constexpr double water_density_kg_m3 = 1000.0;
    static constexpr double fibre_saturation = 0.28;

    double dry_density_kg_m3 = 500.0;
    double moisture = 0.10;  ///< mass of water over dry mass
    double temperature_k = 293.15;
    Complex wall{4.0, -0.25};
    Complex bound_water{5.0, -2.0};

    Grained grained(double frequency_hz) const {
        const double wall_share = dry_density_kg_m3 / wall_density_kg_m3;
        const double water = dry_density_kg_m3 / water_density_kg_m3;  // volume per moisture
        const double bound = water * std::min(moisture, fibre_saturation);
        const double free = water * std::max(moisture - fibre_saturation, 0.0);
        const double wet_share = std::min(wall_share + bound, 1.0);
        const Complex wet_wall = looyenga(
            {.host = wall, .inclusion = bound_water, .inclusion_fraction = bound / wet_share});
        const double pore_share = 1.0 - wet_share;
        const Complex pore = looyenga(
            {.host = 1.0,
             .inclusion = Water{temperature_k}.at(frequency_hz).permittivity,
             .inclusion_fraction = pore_share > 0.0 ? std::min(free / pore_share, 1.0) : 0.0});
        return {
            .along = {wet_share * wet_wall + pore_share * pore, 1.0},
            .across = {lichtenecker(
                           {.host = pore, .inclusion = wet_wall, .inclusion_fraction = wet_share}),
                       1.0}};
    }
    /// For whom the grain does not matter: the mean of both.
    Electrics at(double frequency_hz) const {
        const Grained medium = grained(frequency_hz);
        return {0.5 * (medium.along.permittivity + medium.across.permittivity), 1.0};
    }

    /// Keys: dry_density (50 to 1400 kg/m^3), moisture (0 to 2), temperature_k (default 293.15);
    /// wall_permittivity, wall_loss_tangent, bound_water_permittivity and bound_water_loss_tangent
    /// (defaults 4, 0.0625, 5, 0.4).
    static Wood read(Section& section) {
        const auto medium = [&](const std::string& what, const Complex& usual) {
            const double real =
                section.number(what + "_permittivity", Range::at_least(1.0), usual.real());
            const double loss = section.number(what + "_loss_tangent", Range::between(0.0, 10.0),
                                               -usual.imag() / usual.real());
            return Complex(real, -real * loss);
        };
        const Wood usual;
        return {.dry_density_kg_m3 =
                    section.quantity("dry_density", Unit::density, Range::between(50.0, 1400.0)),
                .moisture = section.number("moisture", Range::between(0.0, 2.0)),
                .temperature_k = section.quantity("temperature", Unit::temperature,
                                                  Range::between(253.15, 333.15), 293.15),
                .wall = medium("wall", usual.wall),
                .bound_water = medium("bound_water", usual.bound_water)};
    }
};

}  // namespace specula
