#pragma once

#include <filesystem>
#include <vector>

#include "sim/core/atomic_file.hpp"

namespace specula {

/// The folders that a path needs and that are not there yet.
class NewFolders {
  public:
    explicit NewFolders(std::filesystem::path folder) {
        if (!folder.has_filename()) folder = folder.parent_path();
        for (; !folder.empty() && !std::filesystem::exists(folder); folder = folder.parent_path())
            missing_.push_back(folder);
    }
    /// Once they were made: those that hold nothing.
    void remove_empty() const {
        std::error_code holds_something;
        for (const auto& folder : missing_) std::filesystem::remove(folder, holds_something);
    }

  private:
    std::vector<std::filesystem::path> missing_;  ///< the innermost first
};

/// Does work that writes `file`: finds out before whether the place takes it, makes its folders, and
/// removes them again where the work throws.
template <typename Work>
auto with_folders_of(const std::filesystem::path& file, const Work& work) {
    const NewFolders made(file.parent_path());
    try {
        check_output_place(file);
        return work();
    } catch (...) {
        made.remove_empty();
        throw;
    }
}

}  // namespace specula
