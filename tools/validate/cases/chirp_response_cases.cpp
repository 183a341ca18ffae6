#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/signal/dechirp.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/spectrum.hpp"
#include "tools/validate/plate_under_radar.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// "PEC", or eps, d_m and backing of a slab inside `material`.
Reflector material_of(const Fields& inp) {
    if (!inp.has("material")) return slab_reflector(inp, "material.");
    if (lower_case(inp.text("material")) == "pec") return perfect_reflector();
    throw NotComputable("does not know the material \"" + inp.text("material") + "\"");
}

void check_sampling(const Fields& inp) {
    inp.describe({"case"});
    if (inp.has("f_n") && inp.text("f_n") != "f0 + B n/N")
        throw NotComputable("does not know the frequencies \"" + inp.text("f_n") + "\"");
}

/// What the mixer delivers, its residual phase taken out again: cases leave it out.
std::vector<double> beat_without_residual(Channel channel, const Chirp& chirp) {
    channel.reference_path_m = 0.0;
    std::vector<double> samples;
    for (const Complex value : dechirp(channel, chirp).analytic) samples.push_back(value.real());
    return samples;
}

/// "bins_1_to_24_db_rect".
void compare_bins(Comparison& compare, const CasePoint& point, const std::string& name,
                  const std::vector<double>& samples) {
    BinSpan bins{0, 0};
    char window[32] = "";
    int end = 0;
    if (std::sscanf(name.c_str(), "bins_%d_to_%d_db_%31[a-z]%n", &bins.first, &bins.last, window,
                    &end) != 3 ||
        name.size() != static_cast<std::size_t>(end))
        return;
    const int n = static_cast<int>(samples.size());
    if (bins.first < 0 || bins.last < bins.first || bins.last > n / 2)
        throw NotComputable("has no such bins as " + name);
    const std::vector<double> expected_db = point.expect.numbers(name);
    const double peak_db = *std::max_element(expected_db.begin(), expected_db.end());
    const auto values = window_values(window, n);
    compare.levels(
        name, levels_db(real_amplitudes(samples, {values, n}, bins)),
        {.split_db = peak_db - 30.0, .above = "db_bins_within_30dB_of_peak", .below = "db_other"});
}

/// The samples have no tolerance of their own: as a whole, that of the strong bins.
void compare_samples(Comparison& compare, const CasePoint& point, const Channel& channel) {
    if (!compare.wants("h_real") || !compare.wants("h_imag")) return;
    const auto real = point.expect.numbers("h_real"), imaginary = point.expect.numbers("h_imag");
    if (real.size() != channel.h.size() || imaginary.size() != channel.h.size())
        point.expect.fail("h_real", "not N numbers", "give one for each sample of the chirp");
    double off = 0.0, sum = 0.0, found = 0.0;
    for (std::size_t i = 0; i < real.size(); ++i) {
        off += std::norm(channel.h[i] - Complex(real[i], imaginary[i]));
        sum += std::norm(Complex(real[i], imaginary[i]));
        found += std::norm(channel.h[i]);
    }
    const double allowed_db =
        point.tolerance.number("db_bins_within_30dB_of_peak", Range::at_least(0.0));
    compare.additional({"norm of h_real and h_imag", std::sqrt(found), std::sqrt(sum),
                        std::sqrt(off / sum), std::pow(10.0, allowed_db / 20.0) - 1.0, "relative"});
}

}  // namespace

std::vector<Quantity> chirp_response_point(const CasePoint& point) {
    constexpr double any_rate_hz = 12.5e6;  // neither frequencies nor bins depend on it
    check_sampling(point.inp);
    const Chirp chirp = chirp_of(point.inp, any_rate_hz);
    const FrequencyComb comb = comb_of(chirp);
    const Reflector reflector = material_of(point.inp);
    const PlateUnderRadar scene = plate_under_radar(point.inp, comb.last_hz());
    const Channel channel = channel_of(scene.scatter(comb.last_hz()), {&reflector, 1}, comb);
    const std::vector<double> samples = beat_without_residual(channel, chirp);
    Comparison compare(point);
    compare_samples(compare, point, channel);
    for (const std::string& name : point.expect.names())
        compare_bins(compare, point, name, samples);
    compare.within("bin_size_m", chirp.bin_m(), {1e-9 * chirp.bin_m(), "m"});
    return compare.finish();
}

}  // namespace specula
