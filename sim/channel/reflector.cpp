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

struct FilledLayer {
    SampleLayer layer;
    Material material;
};

Layer layer_at(double frequency_hz, const FilledLayer& filled, const Sample& sample) {
    const auto& [layer, material] = filled;
    const Electrics medium = material.at(frequency_hz);
    Layer found{.medium = material.is_metal() ? medium : varied(medium, sample),
                .thickness_m = layer.thickness_m,
                .roughness_m = layer.roughness_m,
                .correlation_m = layer.correlation_m};
    if (material.has_grain()) {
        const Grained grained = material.grained(frequency_hz);
        found.grain = {varied(grained.along, sample), varied(grained.across, sample)};
        if (layer.turned) std::swap(found.grain->along, found.grain->across);
    }
    return found;
}

std::function<Backing(double)> backing_of(const Sample& sample, const Library& library) {
    if (sample.backing == "metal") return [](double) { return Backing(PerfectConductor{}); };
    if (sample.backing == "air") return [](double) { return Backing(HalfSpace{}); };
    return [material = known(library, sample.backing)](double frequency_hz) {
        return Backing(HalfSpace{material.at(frequency_hz)});
    };
}

}  // namespace

Reflector reflector_of(const Sample& sample, const Library& library, double yaw_rad) {
    std::vector<FilledLayer> layers;
    for (const SampleLayer& layer : sample.all_layers())
        layers.push_back({layer, known(library, layer.material)});
    return [sample, layers, backing = backing_of(sample, library), yaw_rad](double frequency_hz) {
        Stack stack{{}, backing(frequency_hz), frequency_hz, sample.grain_rad + yaw_rad};
        for (const FilledLayer& layer : layers)
            stack.layers.push_back(layer_at(frequency_hz, layer, sample));
        return stack;
    };
}

}  // namespace specula
