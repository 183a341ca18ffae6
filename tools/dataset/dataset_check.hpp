#pragma once

#include "sim/dataset/dataset_reader.hpp"

namespace specula {

/// Reads all frames of a dataset, a block at a time: hashes, checksums, and values that are not
/// possible. Shows progress where it takes long. Throws InputError naming the file, the object and the
/// row, and Interrupted.
void check_dataset(const DatasetReader& reader);

}  // namespace specula
