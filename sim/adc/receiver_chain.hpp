#pragma once

#include "scenes/radar.hpp"
#include "sim/adc/adc_frame.hpp"
#include "sim/core/random.hpp"
#include "sim/signal/dechirp.hpp"

namespace specula {

/// What reaches the receivers during a session: the sample's echo, which may move and whose level
/// may drift, and everything that stands still with the radar.
struct ReceiverInput {
    BeatSignal echo;
    BeatSignal still;
};

/// How one frame differs from the session it belongs to.
struct FrameState {
    double displacement_m = 0.0;  ///< of the sample away from the radar, |.| << wavelength * 10
    double gain_db = 0.0;         ///< of the whole receiver
};

/// From the antenna ports to ADC codes: gain, thermal noise, IF high-pass, polarity, DC offset,
/// saturating quantisation. Every chirp of the frame has its own noise.
///
/// A displacement d turns the echo by 2 k d at each sample's own frequency, that of the specular
/// foot; off the foot the path changes by the cosine of incidence less (0.5 % at the first Fresnel
/// zone's rim at 45 cm).
/// @eq PHYSICS.md#thermal-noise, #high-pass, #quantisation
class ReceiverChain {
  public:
    explicit ReceiverChain(const Radar& radar);

    /// @in noise  advanced by the same amount for every frame of one radar
    AdcFrame receive(const ReceiverInput& input, const FrameState& state, Stream& noise) const;

    /// Standard deviation of the thermal noise before the high-pass, in LSB.
    double noise_lsb() const { return noise_lsb_; }

  private:
    Radar radar_;
    double signal_lsb_;  ///< code amplitude of a channel of |h| = 1
    double noise_lsb_;
    std::vector<double> wavenumber_rad_m_;  ///< (sample, settling ones included)
};

}  // namespace specula
