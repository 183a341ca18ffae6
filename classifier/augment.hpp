#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "classifier/augmentation.hpp"
#include "classifier/feature_table.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// The beat samples of one frame on their way through the steps, in LSB.
struct FrameSamples {
    int n_rx = 1;
    int n_samples = 0;
    std::vector<double> in_phase;    ///< (chirp, rx, sample)
    std::vector<double> quadrature;  ///< as in_phase, of a complex receiver; else empty
};

/// Changes one frame, and returns what was drawn for each step, (step), in the unit of unit_of.
///
/// Noise, gain and tones are what a linear receiver would add, exactly. Moving turns the analytic
/// signal of all but leakage (tones below bin 2) by the beat and, where the radar's carrier is
/// known, by its phase; noise moves along. The analytic signal of a real chirp is that of one
/// period, so that the first and last samples are off; behind a window, as the descriptor has one,
/// a pure echo from bin 7 on is off by at most 1 % of its peak, and a mirror moved by up to 7 cm
/// agrees with one simulated there within 1 %. Some 2 % of leakage cannot be told from echoes and
/// moves along.
/// @eq  PHYSICS.md#augmentation
/// @in  range_m  of the sample, for its level; below 0: that of the strongest bin
/// @in  key      names the frame and the copy; its purpose is not looked at
/// Throws InputError where a step would move the sample to within three bins of the radar, or moves
/// where the range bin is not known.
std::vector<double> augment_codes(FrameSamples& frame, const Augmentation& how, double range_m,
                                  const StreamKey& key);

/// The same for amplitudes of range bins, a row of one frame, as the descriptor gives them.
///
/// Phases are lost there: noise and tones are added with a phase drawn for each of the rows that
/// the descriptor is the mean of, which is exact for one echo per bin of equal amplitude in all
/// rows. Moved bins are read between the row's bins (Lagrange, six points); what comes in at an end
/// is what stood there. A tone moved by a fraction of a bin is off by at most 2.5 % of its peak.
/// @eq  PHYSICS.md#augmentation
std::vector<double> augment_row(std::span<float> row, const Augmentation& how, double range_m,
                                const StreamKey& key);

/// Rows in, rows out, for use inside training: row i is changed as by augment_row with
/// key.item + i, and the height of the strongest bin. Labels and groups stay.
/// @in  key  name the epoch in key.world, so that every epoch sees other copies
FeatureTable augmented(const FeatureTable& rows, const Augmentation& how, const StreamKey& key);

}  // namespace specula
