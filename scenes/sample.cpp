#include "scenes/sample.hpp"

namespace specula {

std::vector<SampleLayer> Sample::all_layers() const {
    if (!layers.empty()) return layers;
    return {{.material = material, .thickness_m = thickness_m, .roughness_m = roughness_m}};
}

std::string Sample::title() const {
    std::string title;
    for (const SampleLayer& layer : all_layers())
        title += (title.empty() ? "" : " on ") + layer.material;
    return title;
}

Mesh Sample::triangles(const Placement& placement) const {
    return mesh ? placed(*mesh, placement) : triangulate(face, placement);
}

std::vector<BandWarning> band_warnings(const Sample& sample, const Library& library,
                                       const FrequencyBand& used) {
    std::vector<std::string> names;
    for (const SampleLayer& layer : sample.all_layers()) names.push_back(layer.material);
    names.push_back(sample.backing);
    return band_warnings(library, names, used);
}

}  // namespace specula
