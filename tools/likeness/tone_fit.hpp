#pragma once

#include "sim/adc/receiver_chain.hpp"
#include "tools/likeness/least_squares.hpp"

namespace specula {

/// One path in the mean chirp of an RX, as it is before the high-pass.
struct FittedTone {
    double range_m = 0.0;
    double amplitude_lsb = 0.0;
    double phase_rad = 0.0;  ///< of the wave h = |h| exp(j phase) exp(-jk 2 range)
};

/// What makes up the mean chirp of one RX.
struct FittedChannel {
    double dc_lsb = 0.0;
    double dc_error_lsb = 0.0;  ///< standard error: near tones take part of an offset, or give it
    double start_up_lsb = 0.0;
    std::vector<FittedTone> tones;
    Complex echo_factor{1.0, 0.0};  ///< on the known scene's beat
    double residual_lsb = 0.0;      ///< rms of what none of them explains
};

struct ToneSearch {
    double nearest_m = 0.0;  ///< half a bin at least: nearer is not told from the offset
    double farthest_m = 0.15;
    int most_tones = 6;
    /// Stop when a tone lessens the residual's energy by less than this share of the chirp's.
    double least_share = 1e-6;
    double noise_lsb = 0.0;  ///< of the mean chirp; tones below its chance peaks are left out
};

/// Takes chirps of a radar apart: DC offset, start-up pulse, tones, a known echo.
///
/// Every part goes through the receiver's own high-pass, start and start-up, so that a tone of less
/// than a bin is not taken for an offset. Tones are added one by one, each where it explains most,
/// and then moved to their best ranges.
class ChirpFit {
  public:
    explicit ChirpFit(const Radar& radar);

    /// @in  chirp  (sample), LSB
    /// @in  echo   beat of a known scene at this RX, (sample from the ramp's start), per LSB; or
    /// none
    FittedChannel fit(const std::vector<double>& chirp, const ToneSearch& search,
                      const std::vector<Complex>* echo = nullptr) const;

    /// A tone's beat before the high-pass, (sample from the ramp's start).
    std::vector<Complex> beat_of(const FittedTone& tone) const;

    /// Whether the start of the decimation filter shows in the frame.
    bool shows_start_up() const { return !chain_.start_up().empty(); }

  private:
    struct Pair {
        std::vector<double> in_phase, quadrature;
    };
    std::vector<double> seen(const std::vector<double>& beat) const;
    Pair pair_at(double range_m) const;
    Columns base_columns(const std::vector<Complex>* echo) const;
    std::vector<double> find_ranges(const Columns& base, const std::vector<double>& observed,
                                    const ToneSearch& search) const;
    /// Moves tones from number `first` on to where they explain most.
    void refine(const Columns& base, const std::vector<double>& observed, std::size_t first,
                std::vector<double>& ranges_m) const;
    Columns with_tones(Columns columns, const std::vector<double>& ranges_m) const;

    Radar radar_;
    ReceiverChain chain_;
};

/// Where between two samples the start-up pulse lies, by the samples before it; the radar's own
/// value where none of them is in the frame.
/// @in  chirps  (rx) of (sample)
double start_up_fraction(const Radar& radar, const std::vector<std::vector<double>>& chirps);

}  // namespace specula
