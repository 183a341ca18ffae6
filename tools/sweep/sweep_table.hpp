#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/sweep/sweep.hpp"

namespace specula {

/// One column of numbers of a sweep's table.
struct SweepColumn {
    std::string name;  ///< ends with its unit
    std::string unit;
    std::string meaning;
    std::vector<double> values;  ///< (row)
};

/// Every column: what was set, then what came back.
std::vector<SweepColumn> sweep_columns(const Sweep& sweep);

/// The label of each row's specimen, then the columns; numbers with 9 digits.
std::string sweep_csv(const Sweep& sweep);

/// The same as HDF5, in full precision; sim/dataset/FORMAT.md describes it. Whole or not at all.
void write_sweep_hdf5(const std::filesystem::path& file, const Sweep& sweep);

/// A table as it was written, for `specula show`.
struct StoredSweep {
    std::string title, radar, version;
    std::vector<std::string> specimens;
    std::vector<SweepColumn> columns;  ///< `meaning` and `unit` included
};
/// Whether an HDF5 file says that it is one.
bool is_sweep_hdf5(const std::filesystem::path& file);
/// Throws InputError when the file is no such table.
StoredSweep read_sweep_hdf5(const std::filesystem::path& file);

}  // namespace specula
