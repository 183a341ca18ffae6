#pragma once

namespace specula {

/// An oscillator whose phase noise falls by `slope_db_per_decade`.
struct Oscillator {
    double at_1mhz_dbc_hz;  ///< single sideband
    double slope_db_per_decade;

    double level_dbc_hz(double offset_hz) const;
};

/// By how much the beat of an echo keeps the oscillator's phase noise at an offset: both come from
/// the same oscillator, one later by the delay.  4 sin^2(pi f tau), in dB.
/// @eq  Budge and Burt, IEEE National Radar Conference 1993, "range correlation"
struct DelayedNoise {
    double delay_s;
    double offset_hz;
};
double range_correlation_db(const DelayedNoise& noise);

struct NoiseBand {
    double low_hz;
    double high_hz;
    double delay_s;
};
/// Root of the integral of 2 L(f) 4 sin^2(pi f tau) over the band, in radians.
double residual_phase_rms_rad(const Oscillator& oscillator, const NoiseBand& band);

}  // namespace specula
