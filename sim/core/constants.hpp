#pragma once

#include <numbers>

namespace specula {

inline constexpr double pi = std::numbers::pi;
inline constexpr double two_pi = 2.0 * std::numbers::pi;

inline constexpr double speed_of_light_m_s = 299'792'458.0;             ///< exact, SI 2019
inline constexpr double boltzmann_j_k = 1.380'649e-23;                  ///< exact, SI 2019
inline constexpr double vacuum_permeability_h_m = 1.256'637'062'12e-6;  ///< CODATA 2018
inline constexpr double vacuum_permittivity_f_m =
    1.0 / (vacuum_permeability_h_m * speed_of_light_m_s * speed_of_light_m_s);
inline constexpr double vacuum_impedance_ohm = vacuum_permeability_h_m * speed_of_light_m_s;

}  // namespace specula
