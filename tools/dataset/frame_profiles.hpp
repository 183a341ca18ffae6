#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/dataset/dataset.hpp"

namespace specula {

/// Where the energy of frames lies: range profiles of their codes, or their features.
struct FrameProfiles {
    std::size_t n_values = 0;  ///< per frame; 0: such frames have no profile
    std::vector<float> rows;   ///< (frame, value), LSB of codes
    std::span<const float> row(std::size_t i) const {
        return std::span(rows).subspan(i * n_values, n_values);
    }
};

/// What a step along a profile is: "range bin", "sample" or "feature".
std::string profile_axis(const Dataset& dataset);

/// Codes of beat samples: amplitudes of all range bins, mean over chirps and RX, as the firmware
/// computes them; complex ones by a transform of both rails, rectangular window (lengths that are
/// powers of two from 2 to 1024, else none). Samples that are range themselves: their magnitude.
/// Without codes: the profiles that the file holds, mean over RX; else the features.
FrameProfiles frame_profiles(const Dataset& dataset, int threads);

/// Peak of the sample's echo over the noise, in dB: the largest value within two bins of where the
/// height says, or from the fifth bin on where no height is known (below lies leakage), over the
/// median of the upper half of the profile. Not a number where there is no noise to compare with.
/// @in  echo_bin  where the echo is expected; below 0: not known
double profile_snr_db(std::span<const float> profile, double echo_bin);

}  // namespace specula
