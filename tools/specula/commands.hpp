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

struct ValidateArguments {
    std::filesystem::path folder;  ///< of case files, or one of them; empty: the project's own
    std::filesystem::path json;    ///< to write; empty: none
    std::filesystem::path html;
    int threads = 1;
};
/// The exit status: 0, 1 where a tolerance is missed, 3 where a case cannot be computed.
int validate_command(const ValidateArguments& arguments, const Catalogue& catalogue);

/// @in what  "materials", "radars" or "experiments"
void list_command(const std::string& what, const Catalogue& catalogue);

struct ShowArguments {
    std::string what;              ///< a name in the catalogue, a .toml file or a dataset (.h5)
    std::filesystem::path figure;  ///< folder for the figure of a material; empty: none
};
void show_command(const ShowArguments& arguments, const Catalogue& catalogue);

struct CalibrateArguments {
    std::filesystem::path recording;      ///< dataset of an empty or a known scene
    std::string radar = "iwrl6432boost";  ///< that it was made with: a name or a file
    std::filesystem::path scene;          ///< what stood there; empty: nothing
    std::filesystem::path out;            ///< radar file; empty: <radar>_calibrated.toml
};
void calibrate_command(const CalibrateArguments& arguments, const Catalogue& catalogue);

struct LikenessArguments {
    std::filesystem::path recording;
    std::string radar = "iwrl6432boost";
    std::filesystem::path out;  ///< folder; empty: out/likeness
    std::uint64_t seed = 1;
};
void likeness_command(const LikenessArguments& arguments, const Catalogue& catalogue);

/// @in shell  "bash" or "zsh"
void completion_command(const std::string& shell, const std::vector<std::string>& commands);

}  // namespace specula
