#pragma once

#include <complex>
#include <span>
#include <vector>

#include "scenes/radar.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// Phase noise of the ramp, as the beat of echoes of any delay sees it.
///
/// The same oscillator sends and mixes, so what an echo of delay tau keeps is the phase it has
/// gained in tau: 2 pi tau times the frequency error of the moment. The channel is therefore looked
/// at beside the nominal frequency, and near and far echoes, leakage and all RX move together. For
/// a spectrum falling by 20 dB per decade the frequency error is white: one draw per sample, with
/// the power that passes half the sample rate.
/// @eq    PHYSICS.md#range-correlation
/// Limit: f tau << 1 (0.1 dB at 10 m and 1 MHz), and beats below 0.15 of the sample rate: the slope
///        over frequency comes from four neighbours (0.1 dB low there, 0.5 dB at 0.2).
class RampNoise {
  public:
    explicit RampNoise(const Radar& radar);

    bool is_silent() const { return sd_steps_ == 0.0; }
    /// Errors of one chirp, in steps from sample to sample of its frequency comb.
    std::vector<double> draw(std::size_t n_samples, Stream& stream) const;
    /// Moves a beat, one chirp of one RX, to the frequencies that were really sent.
    static void apply(std::span<std::complex<double>> beat, std::span<const double> error_steps);

  private:
    double sd_steps_ = 0.0;
};

}  // namespace specula
