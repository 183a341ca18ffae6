#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "materials/material.hpp"

namespace specula {

/// All materials of a folder, one per TOML file, read once.
class Library {
  public:
    /// Throws InputError when the folder is missing or a file in it is wrong.
    explicit Library(const std::filesystem::path& folder);

    /// Null where there is none of that name.
    const Material* find(const std::string& name) const;
    std::vector<std::string> names() const;  ///< in alphabetical order

  private:
    std::map<std::string, Material> materials_;
};

}  // namespace specula
