#include "tools/bench/scratch_folder.hpp"

#include <unistd.h>

#include <cstdlib>

#include "sim/core/error.hpp"

namespace specula {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "specula-bench-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw SystemError(name + ": cannot create the folder");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace specula
