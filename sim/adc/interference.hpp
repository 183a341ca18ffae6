#pragma once

#include <complex>
#include <span>

#include "scenes/radar.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// What a second radar's ramp leaves in a chirp: where it crosses ours, their difference sweeps
/// through the IF band and is heard as a short chirp.
///
/// Each chirp meets it at a random moment of its period, each RX with a random phase.
/// @eq    PHYSICS.md#interference
/// Limit: the other radar's level does not vary while its ramps cross; no echoes of them.
class Interference {
  public:
    Interference(const Radar& radar, const Interferer& other);

    /// When the other radar's ramp began, before ours did.
    double draw_lead_s(Stream& stream) const { return stream.uniform() * other_.period_s; }
    /// How one chirp meets it at one RX.
    struct Meeting {
        double lead_s;
        double amplitude;  ///< of the beat's numbers
    };
    /// Adds that to a beat, sample by sample from the start of our ramp.
    void add(std::span<std::complex<double>> beat, const Meeting& meeting, Stream& stream) const;

  private:
    Chirp ours_;
    Interferer other_;
};

}  // namespace specula
