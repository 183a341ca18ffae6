#include "materials/brewster.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

BrewsterAngle brewster_angle(const Electrics& medium) {
    const auto reflection = [&](double incidence_rad) {
        const double sine = std::sin(incidence_rad);
        return std::abs(fresnel(Electrics{}, medium, sine * sine).tm);
    };
    if (medium.permittivity.imag() == 0.0) {  // the minimum is a kink that a search finds badly
        const double incidence_rad = std::atan(std::sqrt(medium.permittivity.real()));
        return {incidence_rad, reflection(incidence_rad)};
    }
    // |r_TM| falls to its one minimum and rises to 1. Golden section, to the square root of the
    // rounding of |r_TM|^2.
    constexpr double shorter = 0.3819660112501051;
    double low = 0.0, high = 0.5 * pi;
    double left = low + shorter * (high - low), right = high - shorter * (high - low);
    double at_left = reflection(left), at_right = reflection(right);
    while (high - low > 1e-9) {
        if (at_left < at_right) {
            high = right;
            right = left;
            at_right = at_left;
            left = low + shorter * (high - low);
            at_left = reflection(left);
        } else {
            low = left;
            left = right;
            at_left = at_right;
            right = high - shorter * (high - low);
            at_right = reflection(right);
        }
    }
    const double incidence_rad = 0.5 * (low + high);
    return {incidence_rad, reflection(incidence_rad)};
}

}  // namespace specula
