#pragma once

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/classifier/temporary_folder.hpp"

namespace specula {

inline std::string content_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline std::size_t n_entries(const std::filesystem::path& folder) {
    const std::filesystem::directory_iterator entries(folder);
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

/// The text with its one `from` turned into `to`; a test that edits nothing is a mistake.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("not in the text: " + from);
    return text.replace(at, from.size(), to);
}

/// A folder of made-up description files that goes with the test.
class MadeUpFolder : public TemporaryFolder {
  public:
    /// Writes a file and returns its path.
    std::filesystem::path with(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path() / name).parent_path());
        std::ofstream(path() / name, std::ios::binary) << text;
        return path() / name;
    }
};

/// A file of the project, e.g. "scenes/examples/metal_plate.toml".
inline std::string project_file(const std::string& name) {
    return content_of(std::filesystem::path(SPECULA_SOURCE_DIR) / name);
}

}  // namespace specula
