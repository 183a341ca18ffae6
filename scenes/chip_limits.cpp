#include "scenes/chip_limits.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"

namespace specula {

namespace {

using Interval = ChipLimits::Interval;

std::optional<Interval> read_interval(Section& section, const std::string& name, Unit unit) {
    if (!section.has_quantity(name, unit)) return std::nullopt;
    const auto ends = section.quantities(name, unit, 2, Range::any());
    if (ends[0] > ends[1])
        section.fail_quantity(name, unit, "ends below its start", "write [lowest, highest]");
    return Interval{ends[0], ends[1]};
}

bool holds(const std::optional<Interval>& limit, double value) {
    constexpr double rounding = 1e-9;  // 0.1 GHz steps are no whole numbers in binary
    return !limit || (value >= limit->low - rounding * std::abs(limit->low) &&
                      value <= limit->high + rounding * std::abs(limit->high));
}

bool is_gain_code(const ChipLimits& limits, double gain_db) {
    if (!limits.gain_db || !limits.gain_step_db) return true;
    const double steps = (gain_db - limits.gain_db->low) / *limits.gain_step_db;
    return std::abs(steps - std::round(steps)) < 1e-6;
}

bool is_corner(const std::vector<double>& corners_hz, double corner_hz) {
    return corners_hz.empty() || std::any_of(corners_hz.begin(), corners_hz.end(), [&](double c) {
               return std::abs(c - corner_hz) < 1e-6 * c;
           });
}

/// `175, 350 or 700`
std::string listed_khz(const std::vector<double>& corners_hz) {
    std::string list;
    for (std::size_t i = 0; i < corners_hz.size(); ++i)
        list += (i == 0                       ? ""
                 : i + 1 == corners_hz.size() ? " or "
                                              : ", ") +
                format("{:.4g}", corners_hz[i] * 1e-3);
    return list;
}

}  // namespace

ChipLimits ChipLimits::read(Section section) {
    ChipLimits limits;
    limits.chip = section.text("chip");
    limits.frequency_hz = read_interval(section, "frequency", Unit::frequency);
    if (section.has_quantity("slope_max", Unit::slope))
        limits.slope_max_hz_s = section.quantity("slope_max", Unit::slope, Range::above(0.0));
    limits.sample_rate_hz = read_interval(section, "sample_rate", Unit::frequency);
    if (section.has("n_samples")) {
        const auto ends = section.numbers("n_samples", 2, Range::between(1.0, 1e6));
        limits.n_samples = Interval{ends[0], ends[1]};
    }
    if (section.has_quantity("ramp_max", Unit::time))
        limits.ramp_max_s = section.quantity("ramp_max", Unit::time, Range::above(0.0));
    limits.gain_db = read_interval(section, "gain", Unit::ratio_db);
    if (section.has_quantity("gain_step", Unit::ratio_db))
        limits.gain_step_db = section.quantity("gain_step", Unit::ratio_db, Range::above(0.0));
    if (section.has_quantity("high_pass", Unit::frequency))
        limits.high_pass_hz =
            section.quantities("high_pass", Unit::frequency, 0, Range::between(0.0, 1e8));
    const std::string sampling = section.choice("sampling", {"real", "complex", "both"}, "both");
    limits.real_samples = sampling != "complex";
    limits.complex_samples = sampling != "real";
    section.finish();
    return limits;
}

std::optional<LimitBreach> limit_breach(const ChipLimits& limits, const Chirp& chirp,
                                        const Receiver& receiver) {
    const std::string& chip = limits.chip;
    const double end_hz = chirp.start_hz + chirp.slope_hz_s * chirp.ramp_end_s;
    if (!holds(limits.frequency_hz, chirp.start_hz) || !holds(limits.frequency_hz, end_hz))
        return LimitBreach{
            "start",
            format("the ramp runs from {:.6g} to {:.6g} GHz, and {} has {:.6g} to {:.6g} GHz",
                   chirp.start_hz * 1e-9, end_hz * 1e-9, chip, limits.frequency_hz->low * 1e-9,
                   limits.frequency_hz->high * 1e-9),
            "move the start, lessen the slope or end the ramp earlier"};
    if (limits.slope_max_hz_s && chirp.slope_hz_s > *limits.slope_max_hz_s)
        return LimitBreach{"slope",
                           format("is steeper than {} can sweep, {:.4g} MHz/us", chip,
                                  *limits.slope_max_hz_s * 1e-12),
                           "lessen the slope"};
    if (!holds(limits.sample_rate_hz, chirp.sample_rate_hz))
        return LimitBreach{
            "sample_rate",
            format("{} samples at {:.4g} to {:.4g} MHz", chip, limits.sample_rate_hz->low * 1e-6,
                   limits.sample_rate_hz->high * 1e-6),
            "choose a rate between"};
    if (!holds(limits.n_samples, chirp.n_samples))
        return LimitBreach{"n_samples",
                           format("{} takes {:.0f} to {:.0f} samples of a chirp", chip,
                                  limits.n_samples->low, limits.n_samples->high),
                           "choose a number between"};
    if (chirp.tx_on_s >= chirp.ramp_end_s)
        return LimitBreach{"tx_on",
                           format("the TX would start to send at {:.4g} us, behind the ramp's end "
                                  "at {:.4g} us",
                                  chirp.tx_on_s * 1e6, chirp.ramp_end_s * 1e6),
                           "let it start earlier"};
    if (limits.ramp_max_s && chirp.ramp_end_s > *limits.ramp_max_s)
        return LimitBreach{"ramp_end",
                           format("is longer than the longest ramp of {}, {:.4g} us", chip,
                                  *limits.ramp_max_s * 1e6),
                           "end the ramp earlier"};
    if (!holds(limits.gain_db, receiver.gain_db) || !is_gain_code(limits, receiver.gain_db))
        return LimitBreach{
            "gain",
            format("{} has gains of {:.4g} to {:.4g} dB{}", chip, limits.gain_db->low,
                   limits.gain_db->high,
                   limits.gain_step_db ? format(" in steps of {:.4g} dB", *limits.gain_step_db)
                                       : std::string()),
            "choose one of them"};
    if (!is_corner(limits.high_pass_hz, receiver.high_pass_hz))
        return LimitBreach{
            "high_pass", format("{} has corners of {} kHz", chip, listed_khz(limits.high_pass_hz)),
            "choose one of them"};
    if (receiver.complex_samples ? !limits.complex_samples : !limits.real_samples)
        return LimitBreach{
            "sampling",
            format("{} gives {} samples only", chip, limits.real_samples ? "real" : "complex"),
            "leave the key out or change it"};
    return std::nullopt;
}

}  // namespace specula
