#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace specula {

/// The runner, cross-compiled for a Cortex-M4F with the IWRL6432's memory map.
struct TargetBuild {
    std::filesystem::path program;
    std::filesystem::path map;
    std::filesystem::path archive;  ///< libspecula_firmware.a
    std::filesystem::path folder;   ///< holds the compiler's .ci files, somewhere below
};

/// Removes what CMake has configured in the folder for sources or for a folder of another place: a
/// build that was moved or copied cannot be gone on with. All is compiled anew then.
void forget_build_of_another_place(const std::filesystem::path& home,
                                   const std::filesystem::path& folder);

/// Compiles what has changed; of two processes that want to at once, the second waits.
/// @in  home    the folder with CMakeLists.txt and firmware/
/// @in  folder  to build in; made if missing
/// Throws SystemError, naming the package where a tool is missing.
TargetBuild build_for_target(const std::filesystem::path& home,
                             const std::filesystem::path& folder);

/// How QEMU's mps2-an386 is to run the program.
struct Emulation {
    std::vector<std::string> arguments;  ///< of the program, without spaces and commas
    std::filesystem::path folder;        ///< where its files are
    std::filesystem::path uart;          ///< file for what it sends; empty: nowhere
    bool counted = false;                ///< one instruction takes one nanosecond (-icount)
    std::filesystem::path trace;         ///< file for the address of every instruction; empty: none
};

/// Runs it; returns what it printed. Throws SystemError unless it ends with status 0.
std::string emulate(const TargetBuild& build, const Emulation& emulation);

/// Instructions of each stage of the runner's bench, the empty loop taken off.
/// @in  arguments  "blob", "frames": names of files in the folder
std::map<std::string, double> count_instructions(const TargetBuild& build,
                                                 const std::filesystem::path& folder,
                                                 const std::vector<std::string>& arguments);

}  // namespace specula
