#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace specula {

/// A file whose tables an index shows.
struct IndexedFile {
    std::string name;  ///< beside the index
    std::size_t n_rows = 0;
};

/// Writes an HDF5 file that shows the tables of other files, of the same names and types, one below
/// the other: virtual datasets, so that no row is copied. Attributes and groups are the first
/// file's, but for the group /shard. Throws SystemError.
void write_hdf5_index(const std::filesystem::path& index, const std::vector<IndexedFile>& files);

}  // namespace specula
