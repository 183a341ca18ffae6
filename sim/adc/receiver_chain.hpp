#pragma once

#include <span>

#include "scenes/motion.hpp"
#include "scenes/radar.hpp"
#include "sim/adc/adc_frame.hpp"
#include "sim/adc/high_pass.hpp"
#include "sim/adc/interference.hpp"
#include "sim/adc/ramp_noise.hpp"
#include "sim/core/random.hpp"
#include "sim/signal/dechirp.hpp"

namespace specula {

/// What reaches the receivers during a session: the sample's echo, which may move and whose level
/// may drift, and everything that stands still with the radar. With several TX, a signal holds
/// those of the first TX for each RX, then those of the second, and so on.
struct ReceiverInput {
    BeatSignal echo;
    BeatSignal still;
    BeatSignal board = {};  ///< leakage that drifts by itself; empty where it is part of `still`
};

/// How one frame differs from the session it belongs to.
struct FrameState {
    double displacement_m = 0.0;  ///< of the sample away from the radar, |.| << wavelength * 10
    double gain_db = 0.0;         ///< of the whole receiver
    Motion motion = {};           ///< of the sample within the frame
    std::vector<Complex> board_factor = {};  ///< (rx) of the input's `board`; empty: 1
    StreamKey draw = {};  ///< names the frame; the purposes "ramp" and "interferer" are drawn by it
};

/// Where a frame goes: memory of the caller's.
struct FrameCodes {
    std::span<std::int16_t> in_phase;      ///< (chirp, rx, sample)
    std::span<std::int16_t> quadrature{};  ///< likewise, of a complex receiver
};

/// What a chain works in: whoever records many frames keeps it, and none of them allocates.
struct ReceiverScratch {
    std::vector<Complex> echo_turn{};               ///< (sample): gain and displacement
    std::vector<double> frequency_error{};          ///< (sample); empty: none
    std::vector<double> turns{}, cosine{}, sine{};  ///< (sample)
    std::vector<Complex> beat{};                    ///< (rx, sample)
    std::vector<double> noise{};                    ///< (rail, draw)
};

/// From the antenna ports to ADC codes: feeds, gain, phase noise of the ramp, a second radar,
/// thermal noise, IF high-pass, noise of the ADC, start-up of the decimation filter, DC offset,
/// saturating quantisation. Every chirp of the frame has its own noise; what a radar's file leaves
/// out costs nothing.
///
/// A displacement d turns the echo by 2 k d at each sample's own frequency, that of the specular
/// foot; off the foot the path changes by the cosine of incidence less (0.5 % at the first Fresnel
/// zone's rim at 45 cm). Moving samples turn it sample by sample.
/// @eq PHYSICS.md#thermal-noise, #high-pass, #quantisation, #multiplexing, #motion
class ReceiverChain {
  public:
    explicit ReceiverChain(const Radar& radar);

    /// @in noise  advanced by the same amount for every frame of one radar
    AdcFrame receive(const ReceiverInput& input, const FrameState& state, Stream& noise) const;

    /// The same codes into memory of the caller's, of size codes_per_frame().
    struct Recording {
        Stream& noise;
        ReceiverScratch& scratch;
        FrameCodes codes;
    };
    void record(const ReceiverInput& input, const FrameState& state,
                const Recording& recording) const;
    std::size_t codes_per_frame() const;

    /// One rail without noise, before rounding.
    /// @in  beat  (sample from the start of the ramp), in LSB of the ADC before the high-pass
    /// @out (sample of the frame)
    std::vector<double> settled(const std::vector<double>& beat) const;

    /// Code amplitude of a channel of |h| = 1.
    double signal_lsb() const { return signal_lsb_; }
    /// Standard deviation of the thermal noise of one rail before the high-pass, in LSB.
    double noise_lsb() const { return noise_lsb_; }
    /// What the decimation filter's start adds to the first samples, per LSB of its pulse.
    const std::vector<double>& start_up() const { return start_up_; }

  private:
    struct Chirp;  ///< what one chirp has in common for all RX
    void turn_echo(const FrameState& state, const Chirp& chirp, ReceiverScratch& scratch) const;
    void add_board(const BeatSignal& board, const FrameState& state, const Chirp& chirp, int rx,
                   std::span<Complex> beat) const;
    void arrive(const ReceiverInput& input, const FrameState& state, const Chirp& chirp, int rx,
                std::span<Complex> beat) const;
    struct Rails;  ///< I and Q of all RX
    void digitise(const Rails& rails) const;

    Radar radar_;
    double signal_lsb_;
    double noise_lsb_;
    RampNoise ramp_noise_;
    std::optional<Interference> interference_;
    HighPass high_pass_;
    std::size_t n_dark_;               ///< samples before the TX sends
    std::vector<double> start_up_;     ///< (sample of the frame), as far as it reaches
    std::vector<double> turns_per_m_;  ///< of an echo, (sample, settling ones included)
};

}  // namespace specula
