#include "materials/mixing.hpp"

#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// Not std::pow, which is slower and knows no exact cube.
Complex cube_root(Complex value) {
    return std::polar(std::cbrt(std::abs(value)), std::arg(value) / 3.0);
}

void expect_passive(const Mix& mix) {
    SPECULA_EXPECT(mix.host.real() > 0.0 && mix.host.imag() <= 0.0);
    SPECULA_EXPECT(mix.inclusion.real() > 0.0 && mix.inclusion.imag() <= 0.0);
    SPECULA_EXPECT(mix.inclusion_fraction >= 0.0 && mix.inclusion_fraction <= 1.0);
}

}  // namespace

Complex looyenga(const Mix& mix) {
    const double v = mix.inclusion_fraction;
    const Complex root = (1.0 - v) * cube_root(mix.host) + v * cube_root(mix.inclusion);
    return root * root * root;
}

Complex maxwell_garnett(const Mix& mix) {
    const Complex beta = (mix.inclusion - mix.host) / (mix.inclusion + 2.0 * mix.host);
    const Complex part = mix.inclusion_fraction * beta;
    return mix.host * (1.0 + 3.0 * part / (1.0 - part));
}

Complex bruggeman(const Mix& mix) {
    const double v = mix.inclusion_fraction;
    const Complex b = (2.0 - 3.0 * v) * mix.host + (3.0 * v - 1.0) * mix.inclusion;
    const Complex root = std::sqrt(b * b + 8.0 * mix.host * mix.inclusion);
    // The effective medium lies between its parts, so Re > 0; the other root has Re < 0.
    const Complex effective = 0.25 * (b + root);
    return effective.real() > 0.0 ? effective : 0.25 * (b - root);
}

Complex lichtenecker(const Mix& mix) {
    const double v = mix.inclusion_fraction;
    return std::exp((1.0 - v) * std::log(mix.host) + v * std::log(mix.inclusion));
}

Complex mixed_permittivity(MixingLaw law, const Mix& mix) {
    expect_passive(mix);
    Complex mixed;
    switch (law) {
        case MixingLaw::looyenga:
            mixed = looyenga(mix);
            break;
        case MixingLaw::maxwell_garnett:
            mixed = maxwell_garnett(mix);
            break;
        case MixingLaw::bruggeman:
            mixed = bruggeman(mix);
            break;
        case MixingLaw::lichtenecker:
            mixed = lichtenecker(mix);
            break;
    }
    // Rounding may leave a lossless mix with a gain of 1e-16.
    return {mixed.real(), std::min(mixed.imag(), 0.0)};
}

}  // namespace specula
