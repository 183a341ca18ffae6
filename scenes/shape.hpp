#pragma once

#include "scenes/mesh_file.hpp"
#include "scenes/sample.hpp"

namespace specula {

/// Reads `shape` and its keys: "plate" (size of two, bow), "box" (size of three) or "mesh" (file,
/// unit). Warnings about a mesh are added.
/// @out whether the shape is known to be closed
bool read_shape(Section& section, Sample& sample, std::vector<std::string>& warnings);

/// Reads `rotation`: three angles, about x, then y, then z of the scene. None: no turn.
Rotation read_rotation(Section& section);

}  // namespace specula
