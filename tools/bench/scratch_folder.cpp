#include "tools/bench/scratch_folder.hpp"

#include <unistd.h>

#include <cstdlib>

#include "sim/core/error.hpp"

namespace specula {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::error_code none;
    const fs::path parent = fs::temp_directory_path(none);
    const char* asked = std::getenv("TMPDIR");
    if (none)
        throw SystemError((asked ? std::string(asked) : parent.string()) +
                          ": is no folder for temporary files; set TMPDIR to one");
    std::string name = (parent / "specula-bench-XXXXXX").string();
    if (!::mkdtemp(name.data()))
        throw SystemError(name + ": cannot create the folder; set TMPDIR to one with room");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace specula
