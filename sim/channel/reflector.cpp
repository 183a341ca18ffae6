#include "sim/channel/reflector.hpp"

#include "sim/core/expect.hpp"

namespace specula {

namespace {

const Material& known(const Library& library, const std::string& name) {
    const Material* material = library.find(name);
    SPECULA_EXPECT(material != nullptr);
    return *material;
}

/// This piece's own permittivity: real part and loss tangent scaled apart. A metal's is its own.
Electrics varied(const Electrics& medium, const Sample& sample) {
    const double real = medium.permittivity.real() * sample.permittivity_factor;
    const double loss_tangent =
        -medium.permittivity.imag() / medium.permittivity.real() * sample.loss_factor;
    return {Complex(real, -real * loss_tangent), medium.permeability};
}

std::function<Backing(double)> backing_of(const Sample& sample, const Library& library) {
    if (sample.backing == "metal") return [](double) { return Backing(PerfectConductor{}); };
    if (sample.backing == "air") return [](double) { return Backing(HalfSpace{}); };
    return [material = known(library, sample.backing)](double frequency_hz) {
        return Backing(HalfSpace{material.at(frequency_hz)});
    };
}

}  // namespace

Reflector reflector_of(const Sample& sample, const Library& library) {
    return [sample, material = known(library, sample.material),
            backing = backing_of(sample, library)](double frequency_hz) {
        const Electrics medium = material.at(frequency_hz);
        const Layer layer{.medium = material.is_metal() ? medium : varied(medium, sample),
                          .thickness_m = sample.thickness_m,
                          .roughness_m = sample.roughness_m};
        return Stack{{layer}, backing(frequency_hz), frequency_hz};
    };
}

}  // namespace specula
