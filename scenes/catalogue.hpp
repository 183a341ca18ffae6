#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "materials/library.hpp"
#include "scenes/radar.hpp"

namespace specula {

/// What the program knows by name: materials, radars, experiments and sweeps below one root folder.
struct Catalogue {
    std::filesystem::path root;  ///< holds materials/library, scenes/radars, scenes/experiments
    Library materials;

    static Catalogue open(const std::filesystem::path& root);

    std::vector<std::string> radar_names() const;
    std::vector<std::string> experiment_names() const;
    std::filesystem::path experiment_file(const std::string& name) const;
    std::vector<std::string> dataset_names() const;  ///< none where there is no scenes/datasets
    std::filesystem::path dataset_file(const std::string& name) const;
    std::vector<std::string> sweep_names() const;  ///< none where there is no scenes/sweeps
    std::filesystem::path sweep_file(const std::string& name) const;

    /// The radar that `section.<key>` names: one of the catalogue, or a file beside the section's.
    Radar radar(Section& section, const std::string& key) const;
    /// The radar of a .toml file, or of the IWRL6432BOOST as a TI .cfg sets it up.
    Radar radar_of_file(const std::filesystem::path& file) const;
    /// One of the catalogue, or a file; throws InputError where there is none.
    Radar radar_called(const std::string& name) const;
    /// Checks that `section.<key>` names a material; returns its name.
    std::string material_name(Section& section, const std::string& key) const;
    /// "air", "metal" or a material.
    std::string backing_name(Section& section, const std::string& key) const;
};

}  // namespace specula
