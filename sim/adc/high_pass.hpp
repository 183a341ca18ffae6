#pragma once

namespace specula {

/// Two first-order high-pass poles in a row, as between mixer and ADC: each
/// H(f) = (jf/fc) / (1 + jf/fc), so that two with the same corner have -6 dB there.
///
/// Each pole and its zero lie where sampling puts those of the analog filter; a second tap sets the
/// level at zero frequency and at a quarter of the sample rate.
/// @eq    PHYSICS.md#high-pass
/// Limit: with the corner at a share x of the sample rate, the level lies within 0.32 x^2 dB of
///        H(f)^2 up to a quarter of the rate (0.025 dB for 1400 kHz at 5 MHz) and within 4.9 x^2 dB
///        up to 0.4 of it; the phase within 170 x degrees, as sampling alone allows no other.
class HighPass {
  public:
    /// A corner of 0 lets everything through; corners must lie below half the sample rate.
    struct Corners {
        double first_hz;
        double second_hz;
    };
    HighPass(const Corners& corners, double sample_rate_hz);
    HighPass(double corner_hz, double sample_rate_hz)
        : HighPass(Corners{corner_hz, corner_hz}, sample_rate_hz) {}

    /// The next output for the next input; starts from rest.
    double step(double input) { return second_.step(first_.step(input)); }

  private:
    struct Pole {
        double now = 1.0;
        double before = 0.0;
        double feedback = 0.0;
        bool open = true;
        double last_input = 0.0;
        double last_difference = 0.0;
        double last_output = 0.0;

        Pole() = default;
        /// @in  share  corner over sample rate
        explicit Pole(double share);
        double step(double input) {
            if (open) return input;
            const double difference = input - last_input;
            last_output = feedback * last_output + now * difference + before * last_difference;
            last_input = input;
            last_difference = difference;
            return last_output;
        }
    };
    Pole first_;
    Pole second_;
};

}  // namespace specula
