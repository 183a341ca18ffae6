#pragma once

#include <filesystem>

#include "classifier/model.hpp"

namespace specula {

/// Saves a model as JSON one can read and diff: one row of weights per line, every float as the
/// shortest text that reads back as the same float. The file appears whole or not at all.
/// Throws SystemError where the disk refuses.
void write_model(const Model& model, const std::filesystem::path& file);

/// Reads what write_model wrote, bit for bit.
///
/// @out  layers fit together, class names differ, all numbers are finite, variances and scales >=
/// 0,
///       and the firmware can run it
/// Throws InputError `file: field = value: problem; remedy` for anything else, and for files that
/// are not regular or larger than 16 MiB.
Model read_model(const std::filesystem::path& file);

}  // namespace specula
