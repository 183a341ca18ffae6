#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace specula {

/// What counts as a difference between two files.
struct DiffOptions {
    std::vector<std::string> ignored;  ///< tables, groups (/truth) or root attributes (@seed)
    double tolerance_lsb = 0.0;        ///< of ADC codes, >= 0
    double relative = 0.0;             ///< of floating-point values, share of the larger, >= 0
};

/// A table that differs.
struct FieldDifference {
    std::string table;
    std::string unit;  ///< empty: none told
    std::size_t n_frames = 0;
    std::size_t n_values = 0;
    std::size_t first_frame = 0;
    std::string first_place;       ///< as the table is indexed, e.g. "/adc[12, 0, 2, 17]"
    std::string value_a, value_b;  ///< there
    double largest = 0.0;          ///< |a - b|
};

struct DatasetDiff {
    std::vector<std::string> heads;  ///< attributes, shapes and tables that differ, a line each
    std::vector<FieldDifference> fields;
    std::size_t n_frames = 0;  ///< compared
    std::size_t n_different_frames = 0;
    std::size_t n_tolerated = 0;  ///< values that differ within the tolerance

    bool same() const { return heads.empty() && fields.empty(); }
    /// The field whose difference comes first in the files; nullptr: none differs.
    const FieldDifference* first() const;
};

/// Compares tables, rows and attributes of two files of this program, some rows at a time.
/// Throws InputError naming the file that cannot be read, or an ignored name that neither has.
DatasetDiff diff_datasets(const std::filesystem::path& a, const std::filesystem::path& b,
                          const DiffOptions& options);

}  // namespace specula
