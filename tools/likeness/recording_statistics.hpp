#pragma once

#include <vector>

#include "scenes/radar.hpp"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// The chirps of a recording, all frames in a row.
struct ChirpSeries {
    int n_rx = 0;
    int n_samples = 0;
    std::vector<std::int16_t> codes;  ///< (chirp, rx, sample)

    std::size_t n_chirps() const;
    const std::int16_t* chirp(std::size_t i, int rx) const;
    /// Chirps first to last, the latter not included.
    ChirpSeries part(std::size_t first, std::size_t last) const;
    std::vector<double> mean_chirp(int rx) const;

    /// The codes of a dataset file; throws InputError where it holds none.
    static ChirpSeries read(const std::filesystem::path& file);
};

/// Noise in each bin, as the rms per sample of white noise that would give as much: what remains of
/// three chirps in a row beside a straight line in time, under a Blackman window. Samples before
/// `first` are left out.
/// @out (bin), up to half the number of samples
std::vector<double> noise_per_bin_lsb(const ChirpSeries& series, int rx, int first);

/// Amplitude of each bin under a Blackman window; a tone in the middle of a bin reads its own.
std::vector<double> amplitude_spectrum_lsb(const std::vector<double>& chirp);
/// The mean over chirps of that.
std::vector<double> mean_spectrum_lsb(const ChirpSeries& series, int rx);

/// First sample that shows the ramp itself, with the edge behind it.
int first_settled_sample(const Chirp& chirp);

}  // namespace specula
