#include "tools/specula/firmware_workplace.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/specula/home.hpp"

namespace specula {

namespace fs = std::filesystem;

TemporaryWorkplace::TemporaryWorkplace() {
    std::string name = (fs::temp_directory_path() / "specula_firmware_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
        throw SystemError(format("{}: cannot be made: {}", name, std::strerror(errno)));
    const fs::path beside = fs::read_symlink("/proc/self/exe").parent_path();
    place_ = {.home = home_folder(),
              .host_runner = beside / "fw_runner",
              .build = beside / "cortex-m4",
              .folder = name};
    if (::access(beside.c_str(), W_OK) != 0) place_.build = place_.folder / "cortex-m4";
}

TemporaryWorkplace::~TemporaryWorkplace() {
    std::error_code ignored;
    fs::remove_all(place_.folder, ignored);
}

}  // namespace specula
