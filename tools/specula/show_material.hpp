#pragma once

#include <filesystem>

#include "materials/material.hpp"

namespace specula {

/// Prints what is known of a material; with a folder, draws what it reflects there too, as
/// reflection_NAME.svg, .png and .csv.
void show_material(const Material& material, const std::filesystem::path& figure_folder);

}  // namespace specula
