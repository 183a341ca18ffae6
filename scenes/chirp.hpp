#pragma once

#include <algorithm>

#include "materials/provenance.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// One linear frequency ramp and when the ADC looks at it.
///
/// Sample n is output at (skip + n) / rate after the ramp starts and shows what happened
/// `filter_latency_samples` earlier. Samples that would show what was before the ramp's start show
/// the decimation filter starting up.
struct Chirp {
    double start_hz = 57.5e9;
    double slope_hz_s = 150e12;
    double sample_rate_hz = 5e6;
    int n_samples = 128;
    int skip_samples = 28;
    int filter_latency_samples = 11;
    double ramp_end_s = 33e-6;
    double idle_s = 0.0;      ///< between ramps
    double pass_band = 0.45;  ///< highest beat that the decimation filter passes, in sample rates
    double tx_on_s = 0.0;     ///< after the ramp's start: when the TX begins to send

    /// From chirp to chirp of a frame.
    double period_s() const { return idle_s + ramp_end_s; }
    /// Number of samples between the start of the ramp and the first one kept; below 0 where that
    /// one shows what was before the start.
    int settle_samples() const { return skip_samples - filter_latency_samples; }
    /// Transmit frequency at sample n; n in [-settle_samples(), n_samples).
    double frequency_hz(int n) const;
    double centre_hz() const;
    /// Swept while the samples are taken: slope * n_samples / rate.
    double bandwidth_hz() const;
    /// The frequencies at which samples are taken.
    FrequencyBand band() const {
        return {frequency_hz(std::max(0, -settle_samples())), frequency_hz(n_samples - 1)};
    }
    /// Range bin of an n_samples-point transform: c / (2 B).
    double bin_m() const;
    double bin_of(double range_m) const { return range_m / bin_m(); }
    double beat_hz(double range_m) const;
    /// Farthest range that the decimation filter passes.
    double max_range_m() const;

    static Chirp read(Section& section);
};

}  // namespace specula
