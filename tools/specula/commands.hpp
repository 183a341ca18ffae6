#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scenes/catalogue.hpp"

namespace specula {

/// One function per sub-command; each prints to standard output and throws on error.

struct StudyArguments {
    std::string experiment = "paper";  ///< name in the catalogue, or a .toml file
    std::filesystem::path out;         ///< empty: out/<experiment>
    std::optional<std::uint64_t> seed;
    int threads = 1;
    bool quick = false;
};
void study_command(const StudyArguments& arguments, const Catalogue& catalogue);

struct SimulateArguments {
    std::filesystem::path scene;
    std::filesystem::path out;  ///< empty: <scene>.h5 in the working folder
    std::uint64_t seed = 1;
};
void simulate_command(const SimulateArguments& arguments, const Catalogue& catalogue);

/// @in what  "materials", "radars" or "experiments"
void list_command(const std::string& what, const Catalogue& catalogue);

struct ShowArguments {
    std::string what;              ///< a name in the catalogue, a .toml file or a dataset (.h5)
    std::filesystem::path figure;  ///< folder for the figure of a material; empty: none
};
void show_command(const ShowArguments& arguments, const Catalogue& catalogue);

/// @in shell  "bash" or "zsh"
void completion_command(const std::string& shell, const std::vector<std::string>& commands);

}  // namespace specula
