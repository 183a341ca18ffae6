#pragma once

#include <string>

namespace specula {

/// Codes of the recording count from 0; those of a dataset from the middle of 12 bits.
inline constexpr int infineon_mid_scale = 2048;

/// What `config.json` beside Infineon's `radar.npy` says of an FMCW recording.
struct InfineonConfig {
    std::size_t n_chirps = 0, n_samples = 0, n_rx = 0;
    double start_hz = 0.0, end_hz = 0.0, sample_rate_hz = 0.0;
    double chirp_repetition_s = 0.0, high_pass_hz = 0.0;  ///< 0: unknown

    /// c / (2 B), B the band that the samples sweep.
    double bin_m() const;
};

/// @in  text  the file; keys of `device_config.fmcw_single_shape`
/// Throws InputError: with the byte where it is no JSON, with the key where one is missing or out
/// of range.
InfineonConfig read_infineon_config(const std::string& text);

std::string write_infineon_config(const InfineonConfig& config);

}  // namespace specula
