#pragma once

#include "scenes/scene.hpp"
#include "tools/serve/scene_request.hpp"

namespace specula {

/// The request as a scene file that `specula simulate` and `sweep` take. What a scene file cannot
/// say (noise figure, leakage and slope are the radar's, sessions are an experiment's) stands in
/// comments.
std::string scene_toml(const SceneRequest& request, const Radar& of_file);

/// The same as a scene, the board's changes included.
/// Throws InputError, as reading the file would, or FieldError, where it cannot be.
Scene requested_scene(const SceneRequest& request, const Catalogue& catalogue,
                      const KnownNames& known);

/// The fields that a scene file sets; the others at their defaults.
SceneRequest request_of_file(const std::filesystem::path& file, const Catalogue& catalogue);

}  // namespace specula
