#include <cstdio>

#include "tools/validate/beat_samples.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/spectrum.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// "rect" from "n_peaks_above_0p35_rect": the threshold has a p for its point.
struct PeakName {
    double threshold = 0.35;
    std::string window;
};

bool read_peak_count(const std::string& name, PeakName& peak) {
    int whole = 0, end = 0;
    char digits[16] = "", window[32] = "";
    if (std::sscanf(name.c_str(), "n_peaks_above_%dp%15[0-9]_%31[a-z]%n", &whole, digits, window,
                    &end) != 3 ||
        name.size() != static_cast<std::size_t>(end))
        return false;
    peak = {std::stod(std::to_string(whole) + "." + digits), window};
    return true;
}

}  // namespace

std::vector<Quantity> two_targets_point(const CasePoint& point) {
    const Chirp chirp = chirp_of(point.inp);
    const double first_m = point.inp.number("R1_m", Range::at_least(0.0));
    const double second_m = first_m + point.inp.number("separation_m");
    const int padded = point.inp.count("nfft", Range::between(chirp.n_samples, longest_transform));
    const auto samples = beat_samples(chirp, std::vector{PointEcho{first_m}, PointEcho{second_m}});

    const auto peaks = [&](const std::string& window, double threshold) {
        const auto values = window_values(window, chirp.n_samples);
        const auto profile = real_amplitudes(samples, {values, padded}, {0, padded / 2});
        return local_maxima(profile, threshold);
    };
    double threshold = 0.35;  // the points say it in the name of the count
    Comparison compare(point);
    for (const std::string& name : point.expect.names())
        if (PeakName peak; read_peak_count(name, peak)) {
            threshold = peak.threshold;
            compare.same(name, static_cast<double>(peaks(peak.window, threshold).size()));
        }
    for (const std::string& name : point.expect.names()) {
        char window[32] = "";
        int first = 0, last = 0, end = 0;
        if (std::sscanf(name.c_str(), "peak_ranges_m_%31[a-z]%n", window, &end) == 1 &&
            name.size() == static_cast<std::size_t>(end)) {
            std::vector<double> ranges_m;
            for (const int peak : peaks(window, threshold))
                ranges_m.push_back(peak * chirp.bin_m() * chirp.n_samples / padded);
            compare.absolute(name, ranges_m, "peak_range_m", "m");
        } else if (std::sscanf(name.c_str(), "X_at_native_bins_%d_to_%d_%31[a-z]%n", &first, &last,
                               window, &end) == 3 &&
                   name.size() == static_cast<std::size_t>(end)) {
            if (first < 0 || last < first || last > chirp.n_samples / 2)
                throw NotComputable("has no such bins as " + name);
            const auto values = window_values(window, chirp.n_samples);
            compare.absolute(name,
                             real_amplitudes(samples, {values, chirp.n_samples}, {first, last}),
                             "native_bins_abs", "");
        }
    }
    return compare.finish();
}

}  // namespace specula
