#include "tools/validate/formulas/infinite_plane.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"

namespace specula {

namespace {

struct PlaneReflection {
    Complex te, tm;
};

/// Longitudinal wave number over k in a medium, for kz = k `cosine` in air.
Complex longitudinal(Complex permittivity, Complex cosine) {
    const Complex q = std::sqrt(permittivity - 1.0 + cosine * cosine);
    return q.imag() > 0.0 ? -q : q;
}

/// One face, and all below it seen through the medium above: Airy's sum. For complex angles.
PlaneReflection face(Complex upper_permittivity, Complex lower_permittivity, Complex cosine) {
    const Complex upper = longitudinal(upper_permittivity, cosine);
    const Complex lower = longitudinal(lower_permittivity, cosine);
    const Complex tm_upper = lower_permittivity * upper, tm_lower = upper_permittivity * lower;
    return {(upper - lower) / (upper + lower), (tm_upper - tm_lower) / (tm_upper + tm_lower)};
}

PlaneReflection reflection(const DipoleOverPlane& dipole, Complex cosine) {
    const double k = two_pi * dipole.frequency_hz / speed_of_light_m_s;
    PlaneReflection below{-1.0, 1.0};
    const auto& layers = dipole.layers;
    if (dipole.backing)
        below = face(layers.empty() ? Complex(1.0) : layers.back().permittivity, *dipole.backing,
                     cosine);
    for (std::size_t i = layers.size(); i-- > 0;) {
        const Complex q = longitudinal(layers[i].permittivity, cosine);
        const Complex turn = std::exp(Complex(0.0, -2.0 * k * layers[i].thickness_m) * q);
        const Complex above = i > 0 ? layers[i - 1].permittivity : Complex(1.0);
        const PlaneReflection r = face(above, layers[i].permittivity, cosine);
        below.te = (r.te + below.te * turn) / (1.0 + r.te * below.te * turn);
        below.tm = (r.tm + below.tm * turn) / (1.0 + r.tm * below.tm * turn);
    }
    return below;
}

}  // namespace

Complex dipole_over_plane(const DipoleOverPlane& dipole) {
    const double wavelength_m = speed_of_light_m_s / dipole.frequency_hz;
    const double decay = 4.0 * pi * dipole.height_m / wavelength_m;  // 2kH
    // In u = 2kHt the integrand is exp(-u) times what varies with t: panels end where exp(-u) does
    // not matter, and are short against the slab's own ripple, which has a period of a few in t.
    constexpr double last = 44.0, panel = 0.5;
    const GaussRule& rule = gauss_legendre(16);
    Complex sum = 0.0;
    for (double begin = 0.0; begin < last; begin += panel)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double u = begin + 0.5 * panel * (1.0 + rule.nodes[i]);
            const Complex cosine(1.0, -u / decay);
            const PlaneReflection r = reflection(dipole, cosine);
            sum += 0.5 * panel * rule.weights[i] * std::exp(-u) *
                   (r.te - cosine * cosine * r.tm);
        }
    // -j lambda/(8 pi) * integral over kz, d(kz) = -jk dt along the line, taken towards kz = k.
    const Complex over_kz = sum * Complex(0.0, 1.0) * two_pi / wavelength_m / decay *
                            std::polar(1.0, -decay);
    return Complex(0.0, -wavelength_m / (8.0 * pi)) * over_kz;
}

Complex image_source(const ImageSource& image) {
    const double wavelength_m = speed_of_light_m_s / image.frequency_hz;
    const double distance_m = 2.0 * image.height_m;
    return image.reflection * image.gain * wavelength_m / (4.0 * pi * distance_m) *
           std::polar(1.0, -two_pi * distance_m / wavelength_m);
}

}  // namespace specula
