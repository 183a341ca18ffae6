#include "scenes/sample_layers.hpp"

#include "scenes/mesh_checks.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr std::size_t most_layers = 16;
const Range possible_thickness = Range::inside(0.0, 1.0);
const Range possible_roughness = Range::between(0.0, 0.002);
const Range possible_correlation{.min = 1e-5, .max = 0.1};

double read_correlation(Section& section) {
    return section.quantity("correlation_length", Unit::length, possible_correlation,
                            SampleLayer::usual_correlation_m);
}

/// A height spread wider than the layer would break through it.
void check_roughness(const Section& section, double roughness_m, double thickness_m) {
    if (roughness_m < thickness_m) return;
    section.fail_quantity("roughness", Unit::length,
                          format("is no less than the thickness, {:.4g} mm", thickness_m * 1e3),
                          "the rms height of a face stays below the layer's thickness");
}

SampleLayer read_layer(Section section, const Catalogue& catalogue) {
    SampleLayer layer;
    layer.material = catalogue.material_name(section, "material");
    layer.thickness_m = section.quantity("thickness", Unit::length, possible_thickness);
    layer.roughness_m = section.quantity("roughness", Unit::length, possible_roughness, 0.0);
    check_roughness(section, layer.roughness_m, layer.thickness_m);
    layer.correlation_m = read_correlation(section);
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
    if (section.has_quantity("correlation_length", Unit::length))
        section.fail_quantity("correlation_length", Unit::length, "stands beside layers", remedy);
    for (Section& layer : section.sections("layer"))
        sample.layers.push_back(read_layer(layer, catalogue));
    if (sample.layers.empty() || sample.layers.size() > most_layers)
        section.fail("layer", format("{} layers", sample.layers.size()),
                     format("describe 1 to {} of them", most_layers));
    sample.material = sample.layers.front().material;
    sample.roughness_m = sample.layers.front().roughness_m;
    sample.correlation_m = sample.layers.front().correlation_m;
    sample.thickness_m = 0.0;
    for (const SampleLayer& layer : sample.layers) sample.thickness_m += layer.thickness_m;
}

}  // namespace

void read_matter(Section& section, const Catalogue& catalogue, Sample& sample) {
    bool is_solid = false;
    if (section.has("layer")) {
        read_layers(section, catalogue, sample);
    } else {
        sample.material = catalogue.material_name(section, "material");
        is_solid = sample.mesh && !section.has_quantity("thickness", Unit::length);
        // Of a solid nothing comes back from behind its face: the same matter goes on below it.
        sample.thickness_m = is_solid
                                 ? box_around(*sample.mesh).size().norm()
                                 : section.quantity("thickness", Unit::length, possible_thickness);
        sample.roughness_m = section.quantity("roughness", Unit::length, possible_roughness, 0.0);
        check_roughness(section, sample.roughness_m, sample.thickness_m);
        sample.correlation_m = read_correlation(section);
    }
    sample.grain_rad = section.quantity("grain", Unit::angle, Range::between(-pi, pi), 0.0);
    sample.piece = static_cast<std::uint64_t>(section.count("piece", Range::between(0.0, 2e9), 1));
    if (is_solid && section.has("backing"))
        section.fail("backing", "lies behind a body that is solid",
                     "give it a thickness, or remove the backing");
    sample.backing = is_solid ? sample.material : catalogue.backing_name(section, "backing");
    if (section.has("opaque")) sample.opaque = section.flag("opaque", true);
    if (sample.opaque == false && sample.backing != "air")
        section.fail("opaque", "what lies behind it in contact ends the wave's way",
                     is_solid ? "give it the thickness of its wall" : "remove the backing");
}

}  // namespace specula
