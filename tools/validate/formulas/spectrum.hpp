#pragma once

#include <span>
#include <string>
#include <vector>

#include "materials/electrics.hpp"

namespace specula {

/// A window by its name, "rect", "hann" or "blackman": the firmware's table where it has that
/// length, its definition in double where it has not. Throws NotComputable for other names.
std::vector<double> window_values(const std::string& name, int n_samples);

/// Width in bins of the flat filter that lets the same noise through.
double noise_bandwidth_bins(std::span<const double> window);

/// How a spectrum is taken.
struct Transform {
    std::span<const double> window;  ///< as long as the samples
    int size;                        ///< bins round the circle; the samples are zero-padded to it
};

/// Sum s w exp(-2 pi j i k / size) over Sum w, in double.
///
/// What the firmware computes in float with 16-bit samples, but good to -200 dB instead of its
/// -120 dB: cases hold 0.5 dB at -110 dB.
Complex bin_of(std::span<const Complex> samples, const Transform& transform, int k);

/// Amplitudes of bins [first, last] of a real signal, a tone of amplitude 1 reading 1 (twice what
/// `bin_of` gives).
std::vector<double> real_amplitudes(std::span<const double> samples, const Transform& transform,
                                    int first, int last);

/// In dB.
std::vector<double> levels_db(std::span<const double> amplitudes);

/// Indices of values above `least` with no higher neighbour on either side.
std::vector<int> local_maxima(std::span<const double> amplitudes, double least);

}  // namespace specula
