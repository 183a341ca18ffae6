#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/chirp.hpp"
#include "scenes/receiver.hpp"

namespace specula {

/// What a radar chip can be set to. A limit that the radar's file leaves out is not checked.
struct ChipLimits {
    struct Interval {
        double low = 0.0;
        double high = 0.0;
    };
    std::string chip;
    std::optional<Interval> frequency_hz;  ///< of the whole ramp, start to end
    std::optional<double> slope_max_hz_s;
    std::optional<Interval> sample_rate_hz;
    std::optional<Interval> n_samples;
    std::optional<double> ramp_max_s;  ///< longest ramp
    std::optional<Interval> gain_db;
    std::optional<double> gain_step_db;  ///< gains are gain_db.low plus a multiple of it
    std::vector<double> high_pass_hz;    ///< corners there are; empty: not checked
    bool real_samples = true;
    bool complex_samples = true;

    static ChipLimits read(Section section);
};

/// A setting that the chip does not have.
struct LimitBreach {
    std::string
        setting;  ///< start, slope, sample_rate, n_samples, tx_on, ramp_end, gain, high_pass, sampling
    std::string problem;  ///< names the limit
    std::string remedy;
};

/// The first setting beyond a limit; none where the chip can do it.
std::optional<LimitBreach> limit_breach(const ChipLimits& limits, const Chirp& chirp,
                                        const Receiver& receiver);

}  // namespace specula
