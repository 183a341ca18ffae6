#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "materials/material.hpp"

namespace specula {

/// All materials of a folder, one per TOML file, read once. A file may name others of the folder as
/// its parts; they are read first.
class Library {
  public:
    /// Throws InputError when the folder is missing, a file in it is wrong, or a material is made
    /// of itself.
    explicit Library(const std::filesystem::path& folder);

    /// Null where there is none of that name.
    const Material* find(const std::string& name) const;
    std::vector<std::string> names() const;  ///< in alphabetical order
    /// For reading a file from elsewhere whose parts are in this library, which must outlive it.
    MaterialLookup lookup() const;

  private:
    std::map<std::string, std::shared_ptr<const Material>> materials_;
};

}  // namespace specula
