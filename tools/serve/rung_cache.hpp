#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tools/serve/rung_training.hpp"

namespace specula {

/// Keeps trained models from start to start, in the user's cache folder ($XDG_CACHE_HOME, else
/// ~/.cache). A set belongs to one build of the program and one text of everything it came from;
/// any other is trained anew.
class RungCache {
  public:
    /// @in  origin  all texts that the models depend on
    explicit RungCache(const std::string& origin);
    /// In this folder instead.
    RungCache(const std::string& origin, const std::filesystem::path& parent);

    /// Nothing where there is no set, or one that cannot be read: it is only a cache.
    std::optional<RungSet> load() const;
    /// Throws SystemError where the disk refuses.
    void store(const RungSet& set) const;
    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path folder_;  ///< empty: nowhere
};

}  // namespace specula
