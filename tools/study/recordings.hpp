#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "classifier/feature_table.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/progress.hpp"

namespace specula {

/// How a study is run; none of it but seed and worlds may change a byte of what it writes.
struct RunSettings {
    std::uint64_t seed = 0;
    int worlds = 1;
    int threads = 1;
    std::filesystem::path folder;
};

/// One condition on disk and what the firmware made of it.
struct Recording {
    Condition condition;
    std::filesystem::path file;
    std::string fingerprint;
    FeatureTable features;
    std::size_t weak_echoes = 0;  ///< sessions of which physical optics is known to be off
};

/// Simulates a condition in every world, writes the dataset, reads it back and extracts the
/// descriptors: what follows sees only what is in the file.
Recording record(const Experiment& experiment, const Library& materials, const RunSettings& run,
                 const Condition& condition, Progress& progress);

}  // namespace specula
