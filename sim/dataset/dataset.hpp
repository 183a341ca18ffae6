#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/adc/adc_frame.hpp"
#include "sim/dataset/truth.hpp"

namespace specula {

/// Where a dataset comes from; text that travels in the file.
struct Origin {
    std::string condition;   ///< name of the condition it was made for
    std::string experiment;  ///< the whole experiment file
    std::uint64_t seed = 0;
    std::string version;     ///< of this program
    std::string radar;       ///< name
    double bin_m = 0.0;      ///< range bin of an n_samples-point transform
};

/// Frames and the truth of each. FORMAT.md describes the file.
struct Dataset {
    Origin origin;
    std::vector<std::string> class_names;
    int n_chirps = 0;
    int n_rx = 0;
    int n_samples = 0;
    std::vector<std::int16_t> adc;  ///< (frame, chirp, rx, sample), LSB
    std::vector<Truth> truth;       ///< (frame)

    std::size_t n_frames() const { return truth.size(); }
    std::size_t codes_per_frame() const {
        return static_cast<std::size_t>(n_chirps) * static_cast<std::size_t>(n_rx) *
               static_cast<std::size_t>(n_samples);
    }
    /// A frame as the firmware takes it; valid as long as `adc` is not touched.
    fw_frame frame(std::size_t i) const {
        return {.samples = adc.data() + i * codes_per_frame(),
                .n_chirps = static_cast<std::uint16_t>(n_chirps),
                .n_rx = static_cast<std::uint16_t>(n_rx),
                .n_samples = static_cast<std::uint16_t>(n_samples)};
    }
};

/// Puts the file in place whole or not at all. The same dataset gives the same bytes.
/// Throws SystemError naming the path and the reason.
void write_dataset(const std::filesystem::path& file, const Dataset& dataset);

/// Throws InputError naming the file and the object that is missing or of the wrong shape.
Dataset read_dataset(const std::filesystem::path& file);

}  // namespace specula
