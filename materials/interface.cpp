#include "materials/interface.hpp"

namespace specula {

Complex longitudinal_wavenumber(const Electrics& medium, double sin_squared) {
    const Complex q = std::sqrt(medium.permittivity * medium.permeability - sin_squared);
    return q.imag() > 0.0 ? -q : q;
}

MediumWave wave_in(const Electrics& medium, double sin_squared) {
    return {&medium, longitudinal_wavenumber(medium, sin_squared)};
}

Reflection fresnel(const MediumWave& from, const MediumWave& to) {
    const Electrics &upper = *from.medium, &lower = *to.medium;
    if (upper.permittivity == lower.permittivity && upper.permeability == lower.permeability)
        return {};
    const Complex te_from = lower.permeability * from.q, te_to = upper.permeability * to.q;
    const Complex tm_from = lower.permittivity * from.q, tm_to = upper.permittivity * to.q;
    return {quotient(te_from - te_to, te_from + te_to), quotient(tm_from - tm_to, tm_from + tm_to)};
}

Reflection fresnel(const Electrics& from, const Electrics& to, double sin_squared) {
    return fresnel(wave_in(from, sin_squared), wave_in(to, sin_squared));
}

}  // namespace specula
