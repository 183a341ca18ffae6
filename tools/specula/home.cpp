#include "tools/specula/home.hpp"

#include <cstdlib>

namespace specula {

namespace fs = std::filesystem;

fs::path home_folder() {
    if (const char* set = std::getenv("SPECULA_HOME"); set && *set) return set;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed = program.parent_path().parent_path() / "share/specula";
    if (!error && fs::is_directory(installed / "scenes")) return installed;
    return SPECULA_SOURCE_DIR;
}

}  // namespace specula
