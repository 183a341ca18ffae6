#pragma once

#include <filesystem>
#include <string>

#include "classifier/augmentation.hpp"

namespace specula {

/// What `specula augment` does to a file.
struct AugmentRequest {
    Augmentation how = {};
    std::string recipe = {};      ///< the steps as text, for the file
    int copies = 1;               ///< of each frame, >= 1
    bool keeps_originals = true;  ///< each frame itself stands before its copies
    std::uint64_t seed = 1;
    int threads = 1;
};

/// Writes `out`: each frame of `data`, then its changed copies, with the groups of the original,
/// what was drawn for each copy (/augmentation), and the truth as it is afterwards. Reads and
/// writes a block at a time. The same request gives the same bytes for any number of threads.
/// Returns the fingerprint. Throws InputError where a step cannot be taken, SystemError, and
/// Interrupted for signals; nothing is left then.
std::string augment_dataset(const std::filesystem::path& data, const std::filesystem::path& out,
                            const AugmentRequest& request);

}  // namespace specula
