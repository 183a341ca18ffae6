#pragma once

#include <hdf5.h>

#include <filesystem>
#include <string>

namespace specula {

/// Throws InputError unless a file begins as those of the house format do: of HDF5 1.10 objects,
/// every piece of which has a checksum; and ends where it says. Older forms have none for their structure, so that damage
/// reaches code of HDF5's that does not expect it.
void check_hdf5_superblock(const std::filesystem::path& file);

/// Opens a table that keeps the house format: reached by hard links only; chunked, in this file
/// alone, through no filters but shuffle, gzip and fletcher32; or virtual, as an index of shards.
/// A table that lies elsewhere could read any file of the machine. The caller closes it. Throws
/// InputError.
hid_t open_hdf5_table(hid_t file, const std::filesystem::path& path, const std::string& name);
/// Whether there is a table that it would open.
bool is_house_hdf5_table(hid_t file, const std::string& name);

}  // namespace specula
