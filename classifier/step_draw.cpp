#include "classifier/step_draw.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Steps of one kind in one recipe draw from streams of their own.
StreamKey key_of(const AugmentStep& step, const StepDraw::Place& place) {
    constexpr std::uint64_t odd = 0x9E3779B97F4A7C15ull;  // spreads small numbers over 64 bits
    StreamKey key = place.key;
    key.seed += odd * place.step;
    key.purpose = kind_of(step);
    return key;
}

/// Beyond, a tone is folded back or filtered away; 0: not known.
double farthest_range_m(const RadarView& radar) {
    return radar.max_range_m > 0.0 ? radar.max_range_m : 0.5 * radar.n_samples * radar.bin_m;
}

}  // namespace

StepDraw::StepDraw(const AugmentStep& step, const RadarView& radar, const Place& place)
    : step_(step),
      radar_(radar),
      stream_(key_of(step, place)),
      value_(std::visit([this](const auto& each) { return each.value.sample(stream_); }, step)) {}

void StepDraw::need_bin() const {
    if (!(radar_.bin_m > 0.0))
        throw InputError(
            format("step {}: the range of a bin is not known; name the radar with --radar",
                   kind_of(step_)));
}

std::optional<Tone> StepDraw::tone() {
    if (const auto* leakage = std::get_if<LeakageStep>(&step_)) {
        need_bin();
        return Tone{.amplitude_lsb = value_,
                    .bin = leakage->range_m.sample(stream_) / radar_.bin_m};
    }
    if (const auto* clutter = std::get_if<ClutterStep>(&step_)) {
        need_bin();
        const double range_m = clutter->range_m.sample(stream_);
        return Tone{.amplitude_lsb = value_ / (range_m * range_m), .bin = range_m / radar_.bin_m};
    }
    return {};
}

/// @eq PHYSICS.md#augmentation, #image-source, #bin-shift
std::optional<Move> StepDraw::move(double range_m) {
    if (!is<ShiftStep>() && !is<RangeStep>()) return {};
    need_bin();
    const double moved_m = range_m + value_;
    if (moved_m < static_cast<double>(first_moved_bin) * radar_.bin_m)
        throw InputError(format(
            "step {}: {:.4g} mm would bring a sample at {:.4g} mm to within {} range bins of the "
            "radar, where leakage lies; draw shorter ways",
            kind_of(step_), value_ * 1e3, range_m * 1e3, first_moved_bin));
    if (const double farthest_m = farthest_range_m(radar_); farthest_m > 0.0 && moved_m > farthest_m)
        throw InputError(
            format("step {}: {:.4g} mm would bring a sample at {:.4g} mm beyond the farthest range of "
                   "the chirp, {:.4g} mm; draw shorter ways",
                   kind_of(step_), value_ * 1e3, range_m * 1e3, farthest_m * 1e3));
    const double phase_rad = radar_.start_hz > 0.0
                                 ? two_pi * radar_.start_hz * 2.0 * value_ / speed_of_light_m_s
                                 : two_pi * stream_.uniform();
    return Move{.bins = value_ / radar_.bin_m,
                .level = is<RangeStep>() ? range_m / moved_m : 1.0,
                .phase_rad = phase_rad,
                .keeps_level = is<ShiftStep>()};
}

bool needs_range(const Augmentation& how) {
    for (const AugmentStep& step : how.steps)
        if (std::holds_alternative<ShiftStep>(step) || std::holds_alternative<RangeStep>(step))
            return true;
    return false;
}

}  // namespace specula
