#pragma once

#include <bitset>
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
    std::string version;  ///< of this program
    std::string radar;    ///< name
    double bin_m = 0.0;   ///< range bin of an n_samples-point transform, or of a sample
    std::string source = "simulation";  ///< or "import" and the format it came in
    /// What decides the frames of `specula generate`, one `key = value` per line; else empty.
    std::string recipe;
};

/// What one step along the last axis of the codes is.
enum class SampleAxis {
    beat,   ///< time in a chirp: a range profile is their spectrum
    range,  ///< range itself, as pulsed radars give it
};

/// Frames and the truth of each. FORMAT.md describes the file.
///
/// Codes, range profiles, features, or any of them: a recording that a sensor had processed already
/// has no codes (n_samples = 0).
struct Dataset {
    Origin origin;
    std::vector<std::string> class_names;
    int n_chirps = 0;
    int n_rx = 0;
    int n_samples = 0;
    std::vector<std::int16_t> adc;  ///< (frame, chirp, rx, sample), LSB
    std::vector<Truth> truth;       ///< (frame)

    /// Range profiles of beat samples, mean amplitude over chirps.
    std::vector<float> profile;  ///< (frame, rx, bin), LSB, finite; or empty
    int n_profile_bins = 0;      ///< from bin 0
    double profile_bin_m = 0.0;  ///< range of one bin
    std::string profile_window;  ///< name of the window before the transform

    /// What only recordings have, or lack.
    SampleAxis sample_axis = SampleAxis::beat;
    std::vector<std::int16_t> adc_quadrature;  ///< as adc, of a complex receiver; else empty
    std::vector<std::string> feature_names;    ///< (feature); at most 4096
    std::vector<double> features;              ///< (frame, feature), finite; or empty
    std::vector<std::string> answer_names;     ///< classes the sensor's own classifier knows
    std::vector<float> probability;            ///< (frame, answer) of that classifier; or empty
    bool has_views = false;                    ///< whether truth.view says anything
    std::bitset<truth_columns.size()> unknown_truth;  ///< columns nobody measured

    std::size_t n_frames() const { return truth.size(); }
    std::size_t codes_per_frame() const {
        return static_cast<std::size_t>(n_chirps) * static_cast<std::size_t>(n_rx) *
               static_cast<std::size_t>(n_samples);
    }
    std::size_t profile_per_frame() const {
        return static_cast<std::size_t>(n_rx) * static_cast<std::size_t>(n_profile_bins);
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
