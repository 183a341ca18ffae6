#pragma once

#include <string>

#include "scenes/scene.hpp"

namespace specula {

/// The scene that a file of this text would be; `name` stands for the file in messages.
Scene read_scene_text(const std::string& text, const std::string& name, const Catalogue& catalogue);

}  // namespace specula
