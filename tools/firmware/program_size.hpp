#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace specula {

/// Bytes of one module of the library, from the linker's map.
struct ModuleSize {
    std::size_t code = 0;
    std::size_t constants = 0;
    std::size_t ram = 0;
};

/// Modules of libspecula_firmware.a that the program uses, by source file ("fw_mlp.c").
std::map<std::string, ModuleSize> read_module_sizes(const std::filesystem::path& map_file);

/// The deepest stack below a function, and the functions on the way there.
struct StackDepth {
    std::size_t bytes = 0;
    std::vector<std::string> path;
};

/// Follows the compiler's own frame sizes and calls (-fcallgraph-info=su, the .ci files below a
/// folder). Leaves outside the project's code (memcpy, memset, the compiler's arithmetic) count 0
/// bytes if the compiler did not say otherwise: they are not compiled here.
/// Throws SystemError for recursion, for a frame of unbounded size, and where there are no files.
StackDepth deepest_stack(const std::filesystem::path& folder, const std::string& function);

/// The same of every function of the library that others can call ("fw_" and not static), the
/// deepest first, of equals by name: whoever starts a task gives it what the first of those it
/// calls needs. An interrupt puts up to 104 bytes (with the float registers) on top.
std::vector<StackDepth> public_stacks(const std::filesystem::path& folder);

/// Functions that a library calls and does not hold, sorted.
/// @in  symbols  what nm prints of its members
std::vector<std::string> foreign_symbols(const std::string& symbols);

/// What firmware/README.md says the compiler may call, and nothing else.
bool is_allowed_foreign(const std::string& symbol);

}  // namespace specula
