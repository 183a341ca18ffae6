#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/channel/path.hpp"
#include "sim/signal/dechirp.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/spectrum.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// The beat of a plane wave that a slab sends back, without spreading: its reflection at each
/// frequency times the way there and back.
std::vector<Complex> slab_beat(const Chirp& chirp, Stack slab, double range_m) {
    const FrequencyComb comb = comb_of(chirp);
    Channel channel = silent_channel(1, comb);
    add_path(channel, comb, {.rx = 0, .length_m = 2.0 * range_m, .transfer = 1.0});
    for (int i = 0; i < comb.n; ++i) {
        slab.frequency_hz = comb.at(i);
        channel.of_rx(0)[i] *= stack_reflection(slab, 1.0).te;
    }
    channel.reference_path_m = 2.0 * range_m;
    return dechirp(channel, chirp).analytic;
}

/// Profile of an analytic signal, and its peaks.
struct Profile {
    std::vector<double> amplitude;
    double step_m;

    /// Where the peak nearest to a range is, and its level.
    std::vector<double> peak_near(double range_m) const {
        const auto peaks = local_maxima(amplitude, 0.0);
        if (peaks.empty()) throw NotComputable("finds no peak in the profile");
        const auto distance = [&](int k) { return std::abs(k * step_m - range_m); };
        const int nearest = *std::min_element(
            peaks.begin(), peaks.end(), [&](int a, int b) { return distance(a) < distance(b); });
        return {nearest * step_m, amplitude_db(amplitude[static_cast<std::size_t>(nearest)])};
    }
};

Profile profile_of(const std::vector<Complex>& beat, const Transform& transform, double bin_m) {
    Profile profile{.amplitude = {},
                    .step_m = bin_m * static_cast<double>(beat.size()) / transform.size};
    for (int k = 0; k < transform.size / 2; ++k)
        profile.amplitude.push_back(std::abs(bin_of(beat, transform, k)));
    return profile;
}

/// [range, level] of each peak, in the order of `peaks`.
void compare_peaks(Comparison& compare, const CasePoint& point,
                   const std::vector<std::vector<double>>& peaks) {
    const std::string list = "local_peaks_range_m_and_dB";
    if (!compare.wants(list)) return;
    const auto expected = point.expect.rows(list);
    if (expected.size() > peaks.size()) throw NotComputable("knows the first two echoes only");
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i].size() != 2)
            point.expect.fail(list, "not pairs", "give [range, level] of each peak");
        const std::string peak = list + (i == 0 ? "[0]" : "[1]");
        const auto allowed = [&](const char* key) {
            return point.tolerance.number(key, Range::at_least(0.0));
        };
        compare.beside(peak + "[0]", {peaks[i][0], expected[i][0]}, {allowed("peak_range_m"), "m"});
        compare.beside(peak + "[1]", {peaks[i][1], expected[i][1]}, {allowed("peak_db"), "dB"});
    }
}

void check_descriptions(const Fields& inp) {
    inp.describe({"normalisation"});
    if (!inp.has("normalisation")) return;
    if (inp.text("normalisation").find("complex") == std::string::npos)
        throw NotComputable("knows the profile of the complex signal only");
}

}  // namespace

std::vector<Quantity> slab_echo_point(const CasePoint& point) {
    constexpr double any_rate_hz = 12.5e6;  // bins do not depend on it
    const Chirp chirp = chirp_of(point.inp, any_rate_hz);
    check_descriptions(point.inp);
    const Complex permittivity = point.inp.permittivity("eps");
    const double thickness_m = point.inp.number("d_m", Range::above(0.0));
    const double range_m = point.inp.number("R0_m", Range::at_least(0.0));
    const std::string described = lower_case(point.inp.text("window"));  // "hann(symmetric)"
    const auto window = window_values(described.substr(0, described.find('(')), chirp.n_samples);
    const int padded =
        point.inp.count("nfft_peaks", Range::between(chirp.n_samples, longest_transform));
    const Stack slab{
        .layers = {{.medium = {.permittivity = permittivity}, .thickness_m = thickness_m}}};
    const auto beat = slab_beat(chirp, slab, range_m);
    const double second_m =
        range_m + longitudinal_wavenumber({.permittivity = permittivity}, 0.0).real() * thickness_m;

    Comparison compare(point);
    for (const std::string& name : point.expect.names()) {
        int first = 0, last = 0, end = 0;
        if (std::sscanf(name.c_str(), "native_bins_%d_to_%d_db%n", &first, &last, &end) != 2 ||
            name.size() != static_cast<std::size_t>(end) || first < 0 || last < first ||
            last >= chirp.n_samples)
            continue;
        std::vector<double> levels;
        for (int k = first; k <= last; ++k)
            levels.push_back(amplitude_db(bin_of(beat, {window, chirp.n_samples}, k)));
        compare.levels(name, levels, {-50.0, "native_bins_db_above_minus50", ""});
    }
    if (compare.wants("local_peaks_range_m_and_dB")) {
        const Profile profile = profile_of(beat, {window, padded}, chirp.bin_m());
        compare_peaks(compare, point, {profile.peak_near(range_m), profile.peak_near(second_m)});
    }
    const Reflection face = fresnel(Electrics{}, {.permittivity = permittivity}, 0.0);
    compare.level("first_face_r_db", amplitude_db(face.te), "peak_db");
    if (compare.wants("second_echo_geometric_range_m"))
        compare.within("second_echo_geometric_range_m", second_m,
                       {point.tolerance.number("peak_range_m", Range::at_least(0.0)), "m"});
    return compare.finish();
}

}  // namespace specula
