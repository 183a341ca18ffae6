#include "scenes/sample_layers.hpp"

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t most_layers = 16;
const Range possible_thickness = Range::inside(0.0, 1.0);
const Range possible_roughness = Range::between(0.0, 0.002);

SampleLayer read_layer(Section section, const Catalogue& catalogue) {
    SampleLayer layer;
    layer.material = catalogue.material_name(section, "material");
    layer.thickness_m = section.quantity("thickness", Unit::length, possible_thickness);
    layer.roughness_m = section.quantity("roughness", Unit::length, possible_roughness, 0.0);
    layer.turned = section.choice("grain", {"along", "across"}, "along") == "across";
    section.finish();
    return layer;
}

void read_layers(Section& section, const Catalogue& catalogue, Sample& sample) {
    const char* remedy = "give it in a [[sample.layer]], or remove the layers";
    if (section.has("material")) section.fail("material", "stands beside layers", remedy);
    if (section.has_quantity("thickness", Unit::length))
        section.fail_quantity("thickness", Unit::length, "stands beside layers", remedy);
    if (section.has_quantity("roughness", Unit::length))
        section.fail_quantity("roughness", Unit::length, "stands beside layers", remedy);
    for (Section& layer : section.sections("layer"))
        sample.layers.push_back(read_layer(layer, catalogue));
    if (sample.layers.empty() || sample.layers.size() > most_layers)
        section.fail("layer", format("{} layers", sample.layers.size()),
                     format("describe 1 to {} of them", most_layers));
    sample.material = sample.layers.front().material;
    sample.roughness_m = sample.layers.front().roughness_m;
    sample.thickness_m = 0.0;
    for (const SampleLayer& layer : sample.layers) sample.thickness_m += layer.thickness_m;
}

}  // namespace

void read_matter(Section& section, const Catalogue& catalogue, Sample& sample) {
    if (section.has("layer")) {
        read_layers(section, catalogue, sample);
    } else {
        sample.material = catalogue.material_name(section, "material");
        sample.thickness_m = section.quantity("thickness", Unit::length, possible_thickness);
        sample.roughness_m = section.quantity("roughness", Unit::length, possible_roughness, 0.0);
    }
    sample.grain_rad = section.quantity("grain", Unit::angle, Range::between(-pi, pi), 0.0);
    sample.backing = catalogue.backing_name(section, "backing");
}

}  // namespace specula
