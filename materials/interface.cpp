#include "materials/interface.hpp"

namespace specula {

Complex longitudinal_wavenumber(const Electrics& medium, double sin_squared) {
    const Complex q = std::sqrt(medium.permittivity * medium.permeability - sin_squared);
    return q.imag() > 0.0 ? -q : q;
}

Reflection fresnel(const Electrics& from, const Electrics& to, double sin_squared) {
    if (from.permittivity == to.permittivity && from.permeability == to.permeability) return {};
    const Complex q_from = longitudinal_wavenumber(from, sin_squared);
    const Complex q_to = longitudinal_wavenumber(to, sin_squared);
    const Complex te_from = to.permeability * q_from, te_to = from.permeability * q_to;
    const Complex tm_from = to.permittivity * q_from, tm_to = from.permittivity * q_to;
    return {(te_from - te_to) / (te_from + te_to), (tm_from - tm_to) / (tm_from + tm_to)};
}

}  // namespace specula
