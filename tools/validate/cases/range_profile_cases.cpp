#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/core/format.hpp"
#include "tools/validate/beat_samples.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/spectrum.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Levels of a profile, as expectations name them.
struct WindowedBins {
    BinSpan bins{0, 0};
    std::string window;
};

/// "bins_4_to_20_db_hann"; nothing for other names.
std::optional<WindowedBins> read_bins_name(const std::string& name) {
    WindowedBins read;
    char window[32] = "";
    int end = 0;
    if (std::sscanf(name.c_str(), "bins_%d_to_%d_db_%31[a-z]%n", &read.bins.first, &read.bins.last,
                    window, &end) != 3 ||
        name.size() != static_cast<std::size_t>(end))
        return std::nullopt;
    read.window = window;
    return read;
}

/// "hann_with_leak_bins_0_to_20_db".
struct LeakageBins {
    WindowedBins profile;
    bool with_leak = false;
};
std::optional<LeakageBins> read_leakage_name(const std::string& name) {
    LeakageBins read;
    char window[32] = "", with[32] = "";
    int end = 0;
    if (std::sscanf(name.c_str(), "%31[a-z]_%31[a-z]_leak_bins_%d_to_%d_db%n", window, with,
                    &read.profile.bins.first, &read.profile.bins.last, &end) != 4 ||
        name.size() != static_cast<std::size_t>(end))
        return std::nullopt;
    read.profile.window = window;
    read.with_leak = std::string(with) == "with";
    return read.with_leak || std::string(with) == "without" ? std::optional(read) : std::nullopt;
}

std::vector<double> profile_levels(const std::vector<double>& samples,
                                   const WindowedBins& profile) {
    const int n = static_cast<int>(samples.size());
    const auto& [first, last] = profile.bins;
    if (first < 0 || last < first || last > n / 2)
        throw NotComputable(format("has no bins {} to {} in {} samples", first, last, n));
    const auto window = window_values(profile.window, n);
    return levels_db(real_amplitudes(samples, {window, n}, profile.bins));
}

int peak_bin(const std::vector<double>& samples, const std::string& window) {
    const int n = static_cast<int>(samples.size());
    const auto all = profile_levels(samples, {{0, n / 2}, window});
    return static_cast<int>(std::max_element(all.begin(), all.end()) - all.begin());
}

/// The keys of both kinds of cases.
LevelTolerance level_tolerance() {
    return {.split_db = -60.0, .above = "db_above_minus60", .below = "db_below_minus60"};
}

const std::string peak_prefix = "peak_bin_";  ///< then a window

}  // namespace

std::vector<Quantity> range_bin_point(const CasePoint& point) {
    const Chirp chirp = chirp_of(point.inp);
    const PointEcho echo{.range_m = point.inp.number("R_m", Range::at_least(0.0)),
                         .amplitude = point.inp.number_or("amplitude", 1.0)};
    const auto samples = beat_samples(chirp, std::vector{echo});
    Comparison compare(point);
    compare.relative("f_beat_hz", chirp.beat_hz(echo.range_m), "f_beat_rel");
    compare.relative("fractional_bin", chirp.bin_of(echo.range_m), "f_beat_rel");
    compare.relative("bin_size_m", chirp.bin_m(), "f_beat_rel");
    compare.relative("slope_hz_per_s", chirp.slope_hz_s, "f_beat_rel");
    for (const std::string& name : point.expect.names()) {
        if (const auto profile = read_bins_name(name))
            compare.levels(name, profile_levels(samples, *profile), level_tolerance());
        else if (name.rfind(peak_prefix, 0) == 0)
            compare.same(name, peak_bin(samples, name.substr(peak_prefix.size())));
    }
    return compare.finish();
}

std::vector<Quantity> leakage_point(const CasePoint& point) {
    const Chirp chirp = chirp_of(point.inp);
    const PointEcho mirror{.range_m = point.inp.number_of({"R", "R_m"}, Range::at_least(0.0))};
    const PointEcho leak{.range_m = point.inp.number_of({"Rleak", "Rleak_m"}, Range::at_least(0.0)),
                         .amplitude = std::pow(10.0, point.inp.number("leak_db") / 20.0)};
    const auto without = beat_samples(chirp, std::vector{mirror});
    const auto with = beat_samples(chirp, std::vector{mirror, leak});
    Comparison compare(point);
    for (const std::string& name : point.expect.names())
        if (const auto leakage = read_leakage_name(name))
            compare.levels(name,
                           profile_levels(leakage->with_leak ? with : without, leakage->profile),
                           level_tolerance());
    return compare.finish();
}

}  // namespace specula
