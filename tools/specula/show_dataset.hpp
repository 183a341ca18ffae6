#pragma once

#include <filesystem>

namespace specula {

/// Prints what a dataset holds: shape, origin, classes, codes, features, truth.
void show_dataset(const std::filesystem::path& file);

}  // namespace specula
