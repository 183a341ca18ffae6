#pragma once

#include <complex>

namespace specula {

using Complex = std::complex<double>;

/// a / b for numbers whose squares neither overflow nor vanish: the operator takes care of those at
/// three times the time.
inline Complex quotient(const Complex& a, const Complex& b) {
    return a * std::conj(b) / std::norm(b);
}

/// What a homogeneous medium is at one frequency. Time convention exp(+jwt): a lossy medium has
/// Im(permittivity) <= 0. Both relative, dimensionless.
struct Electrics {
    Complex permittivity{1.0, 0.0};
    double permeability = 1.0;
};

}  // namespace specula
