#pragma once

#include <filesystem>

namespace specula {

/// Prints what is in a dataset: shape, origin, classes, codes, truth, distributions.
/// @in  figure  an .svg or .png file to draw range profiles and distributions in; else a folder for
///              both and the numbers as CSV; empty: none
void show_dataset(const std::filesystem::path& file, const std::filesystem::path& figure);

}  // namespace specula
