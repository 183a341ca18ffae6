#pragma once

#include <complex>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scenes/radar.hpp"
#include "sim/core/distribution.hpp"
#include "sim/core/document.hpp"

namespace specula {

/// Changes that frames might have undergone on another day: noise, gain, leakage, clutter, another
/// distance. Each acts on ADC codes and, as far as amplitudes tell, on descriptors; augment_codes
/// and augment_rows say how exactly.
///
/// Every law is drawn once per frame. Levels are those seen in the codes, behind the IF high-pass.

/// White noise of this standard deviation, LSB.
struct NoiseStep {
    static constexpr std::string_view kind = "noise", main_key = "level_lsb";
    Distribution value;
    static NoiseStep read(Section& section);
};
/// Gain of the whole receiver, dB.
struct GainStep {
    static constexpr std::string_view kind = "gain", main_key = "gain_db";
    Distribution value;
    static GainStep read(Section& section);
};
/// A tone of this amplitude, LSB, at a short apparent range: coupling inside the board.
struct LeakageStep {
    static constexpr std::string_view kind = "leakage", main_key = "level_lsb";
    Distribution value;
    Distribution range_m{0.03};
    static LeakageStep read(Section& section);
};
/// A point that scatters: `value` is its amplitude at 1 m, LSB; it falls with the square of range.
struct ClutterStep {
    static constexpr std::string_view kind = "clutter", main_key = "level_lsb";
    Distribution value;
    Distribution range_m;
    static ClutterStep read(Section& section);
};
/// Everything beyond leakage farther away by `value` metres, its level kept: the window moves.
struct ShiftStep {
    static constexpr std::string_view kind = "shift", main_key = "distance_mm";
    Distribution value;
    static ShiftStep read(Section& section);
};
/// The same with the level that a mirror has there, as the image source's 1/R, and with what the IF
/// high-pass leaves of it: the sample at another height.
struct RangeStep {
    static constexpr std::string_view kind = "range", main_key = "distance_mm";
    Distribution value;
    static RangeStep read(Section& section);
};

using AugmentStep =
    std::variant<NoiseStep, GainStep, LeakageStep, ClutterStep, ShiftStep, RangeStep>;

/// "gain", "range", ... of a step, and the unit that its value is recorded in.
std::string_view kind_of(const AugmentStep& step);
std::string_view unit_of(const AugmentStep& step);

/// What of a radar decides how its frames change with range; zeros: not known.
struct RadarView {
    double bin_m = 0.0;     ///< range of a bin
    double bin_hz = 0.0;    ///< beat frequency of a bin
    double start_hz = 0.0;  ///< sent at the first sample; 0: the carrier's phase is drawn
    double first_pole_hz = 0.0, second_pole_hz = 0.0;  ///< of the IF high-pass
    double max_range_m = 0.0;  ///< beyond, the receiver sees nothing, or elsewhere
    int n_samples = 0;                                 ///< per chirp, of the transform
    int n_rows = 1;     ///< chirps times RX, over which a descriptor is the mean
    int first_bin = 0;  ///< range bin of a descriptor's first value
};
RadarView view_of(const Radar& radar);

/// What the IF high-pass leaves of a tone of bin `to`, over what it leaves of one of bin `from`; 1
/// where poles are not known, 0 where `to` is not above 0.
/// @eq PHYSICS.md#high-pass, the analog pair
std::complex<double> high_pass_ratio(const RadarView& view, double from, double to);

/// Steps in their order, and the radar they are taken for.
struct Augmentation {
    std::vector<AugmentStep> steps;
    RadarView radar;
};

/// [[step]] of a recipe, each with a `kind`. Throws InputError.
std::vector<AugmentStep> read_steps(Section& recipe);
/// "gain=-1:1" or "noise=2" as on a command line. Throws InputError.
AugmentStep step_of(const std::string& text);

}  // namespace specula
