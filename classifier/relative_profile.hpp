#pragma once

#include "classifier/descriptor.hpp"

namespace specula {

/// Complex range bins around the strongest peak, relative to the peak: what is left of an echo when
/// its range and its phase are taken away, which is how its band is coloured and what follows it.
///
/// Per receiver, the windowed mean of all chirps is transformed at the places peak + k - target_bin
/// of bins k of the descriptor, between bins too, and divided by its own value at the peak. The
/// mean over receivers gives (re, im) of every bin; the last feature is ln(mean amplitude at the
/// peak, LSB, times peak / target_bin), in nepers. The peak is that of the firmware's mean profile,
/// as fw_normalise finds it.
///
/// Costs n_rx n_bins n_samples complex multiplications; the firmware has no code for it.
/// @in   dataset     real beat samples
/// @in   descriptor  relative_profile, align and range set
/// @out  (frame, 2 n_bins + 1)
FeatureTable relative_profiles(const Dataset& dataset, const Descriptor& descriptor, int threads,
                               std::atomic<std::size_t>* frames_done = nullptr);

/// The phases of receivers 1, 2, ... against receiver 0 at the peak, each as (cos, sin): where the
/// echo comes from, and so the only direct sign of a tilt.
/// @out  (frame, 2 (angle_rx - 1)), row-major
/// Throws InputError where the frames do not have angle_rx receivers.
std::vector<float> angle_cues(const Dataset& dataset, const Descriptor& descriptor, int threads);

}  // namespace specula
