#pragma once

#include <filesystem>

#include "sim/core/error.hpp"

namespace specula {

/// The file of a dataset that somebody names: itself, or of a folder of shards its index. Throws
/// InputError for a folder that has none.
inline std::filesystem::path dataset_file(const std::filesystem::path& named) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(named, ignored)) return named;
    const std::filesystem::path index = named / "index.h5";
    if (!std::filesystem::exists(index, ignored))
        throw InputError(named.string() +
                         ": is a folder without index.h5; name a dataset (.h5), or finish the "
                         "folder with specula generate");
    return index;
}

}  // namespace specula
