#include <cstdio>

#include "tools/validate/beat_samples.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/spectrum.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Some bins of a profile through a window.
struct BinRange {
    int first = 0, last = 0;
    std::string window;
};

void check(const BinRange& bins, const Chirp& chirp, const std::string& name) {
    if (bins.first < 0 || bins.last < bins.first || bins.last > chirp.n_samples / 2)
        throw NotComputable("has no such bins as " + name);
}

std::vector<double> levels(const std::vector<double>& samples, const BinRange& bins) {
    const auto window = window_values(bins.window, static_cast<int>(samples.size()));
    return levels_db(real_amplitudes(samples, {window, static_cast<int>(samples.size())},
                                     bins.first, bins.last));
}

int peak_bin(const std::vector<double>& samples, const std::string& window) {
    const auto all = levels(samples, {0, static_cast<int>(samples.size() / 2), window});
    return static_cast<int>(std::max_element(all.begin(), all.end()) - all.begin());
}

constexpr const char* longest_word = "%31[a-z]";  ///< the pattern of a window's name
constexpr double split_db = -60.0;

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
    const std::string bins_pattern = std::string("bins_%d_to_%d_db_") + longest_word + "%n";
    const std::string peak_pattern = std::string("peak_bin_") + longest_word + "%n";
    for (const std::string& name : point.expect.names()) {
        BinRange bins;
        char window[32] = "";
        int end = 0;
        if (std::sscanf(name.c_str(), bins_pattern.c_str(), &bins.first, &bins.last, window,
                        &end) == 3 &&
            name.size() == static_cast<std::size_t>(end)) {
            bins.window = window;
            check(bins, chirp, name);
            compare.levels(name, levels(samples, bins),
                           {split_db, "db_above_minus60", "db_below_minus60"});
        } else if (std::sscanf(name.c_str(), peak_pattern.c_str(), window, &end) == 1 &&
                   name.size() == static_cast<std::size_t>(end)) {
            compare.exact(name, peak_bin(samples, window));
        }
    }
    return compare.finish();
}

std::vector<Quantity> leakage_point(const CasePoint& point) {
    const Chirp chirp = chirp_of(point.inp);
    const PointEcho mirror{.range_m = point.inp.number_of({"R", "R_m"}, Range::at_least(0.0))};
    const PointEcho leak{
        .range_m = point.inp.number_of({"Rleak", "Rleak_m"}, Range::at_least(0.0)),
        .amplitude = std::pow(10.0, point.inp.number("leak_db") / 20.0)};
    const auto without = beat_samples(chirp, std::vector{mirror});
    const auto with = beat_samples(chirp, std::vector{mirror, leak});
    Comparison compare(point);
    for (const std::string& name : point.expect.names()) {
        BinRange bins;
        char window[32] = "", which[32] = "";
        int end = 0;
        if (std::sscanf(name.c_str(), "%31[a-z]_%31[a-z]_leak_bins_%d_to_%d_db%n", window, which,
                        &bins.first, &bins.last, &end) != 4 ||
            name.size() != static_cast<std::size_t>(end))
            continue;
        const std::string kind = which;
        if (kind != "with" && kind != "without") continue;
        bins.window = window;
        check(bins, chirp, name);
        compare.levels(name, levels(kind == "with" ? with : without, bins),
                       {split_db, "db_above_minus60", "db_below_minus60"});
    }
    return compare.finish();
}

}  // namespace specula
