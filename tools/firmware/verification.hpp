#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/firmware/cycle_model.hpp"
#include "tools/firmware/program_size.hpp"
#include "tools/firmware/verify_input.hpp"

namespace specula {

/// One way to compute the same classes: arithmetic of the network, and how spectra are made.
struct Variant {
    std::string name;  ///< "float32", "int16", "int8"; with "HWA-like" where the spectrum is
    fw_arithmetic arithmetic = FW_ARITHMETIC_FLOAT;
    fw_range_path path = FW_RANGE_FLOAT;
};
const std::vector<Variant>& all_variants();
/// Those that a model can be run in: a peak's shape is taken from the float spectrum alone.
std::vector<Variant> variants_of(const Model& model);

/// Frames in which two builds differ in a single bit or more.
struct Mismatches {
    std::size_t features = 0;
    std::size_t logits = 0;
    std::size_t probabilities = 0;
    std::size_t rest = 0;        ///< status, frame quality, monitors
    std::size_t uart_bytes = 0;  ///< bytes, not frames; all of them if the lengths differ

    std::size_t total() const { return features + logits + probabilities + rest + uart_bytes; }
};

/// Frames of which the firmware said something, on the host.
struct FrameFlags {
    std::size_t refused = 0;         ///< a status that was not FW_OK
    std::size_t saturated = 0;       ///< samples at a limit of the converter
    std::size_t dead = 0;            ///< rows whose samples are all equal
    std::size_t cut_bins = 0;        ///< bins cut off in the HWA-like transform
    std::size_t clipped_inputs = 0;  ///< features beyond an integer network's reach
    std::size_t suspicious = 0;      ///< any of these, or unlike the training rows
};

struct VariantResult {
    Variant variant;
    std::size_t n_frames = 0;
    std::size_t n_uart_bytes = 0;
    FrameFlags flags;
    Mismatches host_target;   ///< the host's runner against the emulated Cortex-M4F
    Mismatches host_library;  ///< the host's runner against the library inside this program
};

/// One stage of the firmware on the target.
struct StageCost {
    double instructions = 0.0;
    CycleRange cycles;
};

struct Verification {
    std::vector<VariantResult> variants;
    /// (arithmetic's name, stage) -> cost; the float network's run also has all other stages.
    std::map<std::string, std::map<std::string, StageCost>> stages;
    std::map<std::string, ModuleSize> modules;
    std::vector<StackDepth> stacks;    ///< of every public function, the deepest first
    std::vector<std::string> foreign;  ///< functions that the library needs from elsewhere
    std::size_t model_bytes = 0, scratch_bytes = 0;

    std::size_t mismatches() const;
};

/// Where things are, and what may be counted up.
struct Workplace {
    std::filesystem::path home;         ///< with CMakeLists.txt
    std::filesystem::path host_runner;  ///< the program fw_runner
    std::filesystem::path build;        ///< for the target's program
    std::filesystem::path folder;       ///< for files in between; exists
};

/// Pushes all frames through three builds of the firmware, and measures the target's.
Verification verify_firmware(const VerifyInput& input, const Workplace& place);

/// Stage costs of one model on one frame, by the emulator.
std::map<std::string, StageCost> measure_stages(const TargetBuild& build,
                                                const std::filesystem::path& folder,
                                                const Model& model, const Variant& variant);

/// Frames in the layout the runner reads.
void write_frames(const Dataset& frames, const std::filesystem::path& file);

}  // namespace specula
