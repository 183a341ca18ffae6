#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "scenes/vector3.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// A measured or computed pattern: gains in dBi on a rectangular grid of azimuth (atan2(d.x,
/// d.boresight)) and elevation (asin(d.y)), both ascending. Between grid lines the gain in dB runs
/// straight along either angle; nothing is radiated beyond the grid.
/// @eq PHYSICS.md#antenna-table
struct TablePattern {
    static constexpr std::string_view kind = "table";
    std::vector<double> azimuths_rad{-1.0, 1.0};
    std::vector<double> elevations_rad{-1.0, 1.0};
    std::vector<double> gains_dbi{0.0, 0.0, 0.0, 0.0};  ///< (elevation, azimuth)

    double gain(const Vector3& direction) const;
    /// `file`: a CSV beside the radar's own file, `azimuth_deg,elevation_deg,gain_dbi` per row.
    static TablePattern read(Section& section);
};

/// Reads such a CSV, rows in any order. Throws InputError `file:line: ...` for what is no number, a
/// direction that is missing, twice or off the sphere, and a grid that leaves out the boresight.
TablePattern read_antenna_table(const std::filesystem::path& file);

}  // namespace specula
