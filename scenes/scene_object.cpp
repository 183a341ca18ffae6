#include "scenes/scene_object.hpp"

#include "scenes/sample_layers.hpp"
#include "scenes/shape.hpp"
#include "sim/core/format.hpp"

namespace specula {

Placement SceneObject::placement(const Pose& pose) const {
    if (!fixed_to_sample) return own_placement;
    const Placement sample = sample_placement(pose);
    return {sample.rotation * own_placement.rotation, sample.point(own_placement.shift_m)};
}

SceneObject read_object(Section section, const Catalogue& catalogue, int number,
                        std::vector<std::string>& warnings) {
    SceneObject object;
    object.name = section.text("name", format("object {}", number));
    object.is_watertight = read_shape(section, object.matter, warnings);
    object.own_placement.rotation = read_rotation(section);
    if (section.has_quantity("position", Unit::length)) {
        const auto p = section.quantities("position", Unit::length, 3, Range::between(-100., 100.));
        object.own_placement.shift_m = {p[0], p[1], p[2]};
    }
    object.fixed_to_sample = section.choice("fixed_to", {"room", "sample"}, "room") == "sample";
    read_matter(section, catalogue, object.matter);
    section.finish();
    return object;
}

}  // namespace specula
