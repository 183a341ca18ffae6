#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "classifier/feature_table.hpp"
#include "sim/dataset/truth.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/progress.hpp"

namespace specula {

class FrozenCalibration;

/// How a study is run; none of it but seed and worlds may change a byte of what it writes.
struct RunSettings {
    std::uint64_t seed = 0;
    int worlds = 1;
    int threads = 1;
    std::filesystem::path folder;
    std::vector<std::string> kinds{};  ///< RungPlan::kind of what recordings are described as too
    /// Told of every condition before the first of its sessions is simulated; may be empty.
    std::function<void(const Condition&)> before_recording{};
};

/// One condition on disk and what the firmware made of it.
struct Recording {
    Condition condition;
    std::filesystem::path file;
    std::string fingerprint;
    FeatureTable features;
    std::map<std::string, FeatureTable> described;  ///< by RungPlan::kind
    std::vector<Truth> truth;                       ///< (frame)
    std::size_t weak_echoes = 0;  ///< sessions of which physical optics is known to be off
};

/// Where recordings come from. Borrows both.
struct Source {
    const Experiment& experiment;
    const Library& materials;
};

/// Simulates the training recordings in every world, writes the dataset, reads it back and extracts
/// the descriptors: what follows sees only what is in the file.
Recording record_nominal(const Source& source, const RunSettings& run, Progress& progress);

/// The same for any other condition, once the calibration is frozen.
Recording record_shifted(const FrozenCalibration& frozen, const Source& source,
                         const RunSettings& run, const Condition& condition, Progress& progress);

/// What is looked at once and not kept as a file.
struct PassingRecording {
    FeatureTable features;
    std::map<std::string, FeatureTable> described;
    std::string fingerprint;
};
PassingRecording observe(const FrozenCalibration& frozen, const Source& source,
                         const RunSettings& run, const Condition& condition, Progress& progress);

/// The rows recorded at one of a condition's heights and tilts, counted as Condition::pose does.
FeatureTable rows_of_geometry(const FeatureTable& rows, const Condition& condition, int geometry);

}  // namespace specula
