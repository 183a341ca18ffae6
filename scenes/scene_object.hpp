#pragma once

#include "scenes/catalogue.hpp"
#include "scenes/pose.hpp"
#include "scenes/sample.hpp"

namespace specula {

/// Something beside the sample: a table, a wall, a fixture.
struct SceneObject {
    std::string name;
    Sample matter;
    Placement own_placement;  ///< in the room, or in the sample's own frame
    bool fixed_to_sample = false;
    bool is_watertight = false;

    /// From the object's own frame to the scene.
    Placement placement(const Pose& pose) const;
};

/// Reads one [[object]]; `number`, from 1, names it where it has no name. Warnings are added.
SceneObject read_object(Section section, const Catalogue& catalogue, int number,
                        std::vector<std::string>& warnings);

}  // namespace specula
