#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace specula {

/// What a sweep turns, and in which plane.
struct Tilting {
    bool sensor = true;  ///< about its own phase centre; else the sample about the scene's pivot
    bool elevation = false;  ///< else azimuth

    bool operator==(const Tilting&) const = default;
    std::string title() const;  ///< "sample tilted in azimuth"
};

/// A sample without its size.
struct Specimen {
    std::string label;
    Sample sample;
};

/// What is drawn against tilt and height.
struct PlottedLevel {
    std::string column;  ///< of the table
    std::string title;   ///< of the axis
};
const std::vector<PlottedLevel>& plotted_levels();

/// The product of all its axes is simulated. Of each there is at least one value.
struct SweepPlan {
    std::string name;    ///< for folders and files
    std::string title;   ///< for people
    std::string source;  ///< text of the file it came from
    Scene scene;         ///< gives all that no axis gives
    std::vector<Specimen> specimens;
    std::vector<std::array<double, 2>> sizes_m;  ///< (x, y)
    std::vector<double> heights_m;
    std::vector<Tilting> tiltings;
    std::vector<double> tilts_rad;
    std::vector<double> frequencies_hz;  ///< equal steps; empty: mean over the samples of the chirp
    std::optional<std::size_t>
        plotted;  ///< in `plotted_levels`; else tilt over mirror, height in dBm

    std::size_t n_geometries() const {
        return sizes_m.size() * heights_m.size() * tiltings.size() * tilts_rad.size();
    }
    std::size_t n_frequencies() const { return std::max<std::size_t>(1, frequencies_hz.size()); }
    std::size_t n_rows() const { return n_geometries() * specimens.size() * n_frequencies(); }
};

/// Which value of every axis.
struct SweepIndex {
    std::size_t specimen = 0, size = 0, tilting = 0, height = 0, tilt = 0, frequency = 0;
};

/// Axes as written, each empty where the scene or the sweep file shall say. Units: degrees, mm,
/// GHz, micrometres (roughness).
struct SweepAxes {
    std::string tilt{}, tilted{}, tilt_plane{}, height{}, frequency{};
    std::string material{}, size{}, thickness{}, roughness{}, correlation{}, plot{};
};

/// Reads a scene file, or a sweep file (keys: scenes/README.md), with the axes given beside it.
/// Throws InputError for axes that cannot be, too many points, heights the radar is blind to.
SweepPlan read_sweep_plan(const std::filesystem::path& file, const SweepAxes& axes,
                          const Catalogue& catalogue);

}  // namespace specula
