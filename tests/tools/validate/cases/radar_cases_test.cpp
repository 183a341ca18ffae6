#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/sim/spectrum.hpp"
#include "tests/tools/validate/made_up_case.hpp"

// Chirps, noise and filters that no reference file has, beside their definitions.

namespace specula {
namespace {

using Json = nlohmann::json;
using C = std::complex<double>;

struct Ramp {
    double f0_hz, b_hz, fs_hz;
    int n;

    Json inp() const { return {{"f0_hz", f0_hz}, {"B_hz", b_hz}, {"fs_hz", fs_hz}, {"N", n}}; }

    std::vector<double> tone(double range_m, double amplitude) const {
        const double slope = b_hz * fs_hz / n, tau = 2.0 * range_m / speed_of_light_m_s;
        std::vector<double> samples;
        for (int i = 0; i < n; ++i)
            samples.push_back(amplitude * std::cos(two_pi * (f0_hz * tau + slope * tau * i / fs_hz -
                                                             0.5 * slope * tau * tau)));
        return samples;
    }
};

double level_at(const std::vector<double>& samples, const std::string& window, int bin) {
    return 20.0 * std::log10(amplitude_at(samples, window, bin));
}

const Json tight{{"db_above_minus60", 0.002}, {"db_below_minus60", 0.1}, {"f_beat_rel", 1e-12}};

TEST_CASE("another chirp has its bins where its own closed form has them", "[validate][F01]") {
    // 128 samples have a table in the firmware, 200 have none.
    for (const Ramp& ramp : {Ramp{57.5e9, 3.84e9, 5e6, 128}, Ramp{76e9, 1.1e9, 3.3e6, 200}}) {
        const double range_m = 0.613, amplitude = 0.37;
        const auto samples = ramp.tone(range_m, amplitude);
        Json inp = ramp.inp();
        inp["R_m"] = range_m;
        inp["amplitude"] = amplitude;
        Json expect{{"f_beat_hz", ramp.b_hz * ramp.fs_hz / ramp.n * 2.0 * range_m / 299792458.0},
                    {"bin_size_m", 299792458.0 / 2.0 / ramp.b_hz},
                    {"fractional_bin", range_m * 2.0 * ramp.b_hz / 299792458.0}};
        for (const char* window : {"rect", "hann", "blackman"}) {
            Json levels = Json::array();
            for (int k = 2; k <= 23; ++k) levels.push_back(level_at(samples, window, k));
            expect[std::string("bins_2_to_23_db_") + window] = levels;
        }
        check_passes(case_of("F01_range_bin", inp, expect, tight));
    }
}

TEST_CASE("a window that is unknown is said to be so", "[validate][F01]") {
    Json inp = Ramp{57.5e9, 3.84e9, 5e6, 128}.inp();
    inp["R_m"] = 0.4;
    for (const char* name : {"bins_2_to_3_db_kaiser", "bins_2_to_999_db_hann", "bins_2_3_db_hann"})
        CHECK(validated(case_of("F01_range_bin", inp, {{name, {0.0, 0.0}}}, tight)).verdict() ==
              Verdict::not_computable);
}

TEST_CASE("another leak adds its own tone", "[validate][F11]") {
    const Ramp ramp{60e9, 2e9, 10e6, 64};
    auto samples = ramp.tone(0.72, 1.0);
    const auto leak = ramp.tone(0.031, std::pow(10.0, -13.0 / 20.0));
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += leak[i];
    Json levels = Json::array();
    for (int k = 0; k <= 12; ++k) levels.push_back(level_at(samples, "hann", k));
    check_passes(case_of("F11_leakage",
                         {{"f0", ramp.f0_hz},
                          {"B", ramp.b_hz},
                          {"N", ramp.n},
                          {"fs", ramp.fs_hz},
                          {"Rleak", 0.031},
                          {"leak_db", -13.0},
                          {"R", 0.72}},
                         {{"hann_with_leak_bins_0_to_12_db", levels}}, tight));
}

TEST_CASE("two other targets add up, phase and all", "[validate][F04]") {
    const Ramp ramp{58e9, 4e9, 12.5e6, 128};
    auto samples = ramp.tone(0.5, 1.0);
    const auto second = ramp.tone(0.583, 1.0);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] += second[i];
    Json amplitudes = Json::array();
    for (int k = 5; k <= 20; ++k) amplitudes.push_back(amplitude_at(samples, "hann", k));
    Json inp = ramp.inp();
    inp["R1_m"] = 0.5;
    inp["separation_m"] = 0.083;
    inp["nfft"] = 2048;
    check_passes(
        case_of("F04_two_targets", inp,
                {{"X_at_native_bins_5_to_20_hann", amplitudes}, {"n_peaks_above_0p35_hann", 2}},
                {{"native_bins_abs", 1e-6}, {"peak_range_m", 0.002}}));
}

TEST_CASE("phase follows any shift, through many turns and backwards", "[validate][F03][F05]") {
    for (const double shift_m : {0.0123, -0.2, 3e-7})
        check_passes(case_of("F03_phase_displacement", {{"f_hz", 77e9}, {"dz_m", shift_m}},
                             {{"dphase_rad", 4.0 * pi * shift_m * 77e9 / 299792458.0}},
                             {{"rel", 1e-6}}));
    const double phase = 4.0 * pi * -31.0 * 150e-6 * 62e9 / 299792458.0;  // beyond half a turn
    check_passes(case_of("F05_doppler",
                         {{"v_m_s", -31.0}, {"f_hz", 62e9}, {"Tc_s", 150e-6}, {"Nc", 48}},
                         {{"phase_per_chirp_rad", phase},
                          {"phase_wrapped_rad", std::remainder(phase, two_pi)},
                          {"doppler_bin", 48 * phase / two_pi},
                          {"doppler_bin_aliased", 48 * std::remainder(phase, two_pi) / two_pi},
                          {"v_max_unambiguous", 299792458.0 / 62e9 / 600e-6},
                          {"v_res", 299792458.0 / 62e9 / (96 * 150e-6)}},
                         {{"rel", 1e-9}}));
}

TEST_CASE("another receiver's noise is kTF, wherever it is read off", "[validate][F06]") {
    const double psd = 10.0 * std::log10(1.380649e-23 * 330.0 * 1e3) + 9.5;
    const double enbw = 1.7400990099009901;  // of a Blackman window: its textbook 1.73 is N -> inf
    const double mirror =
        7.0 + 20.0 * std::log10(299792458.0 / 79e9 / (8.0 * pi * 0.8)) + 2.0 * 6.5;
    const double bin = psd + 10.0 * std::log10(5e6 / 128);
    check_passes(case_of("F06_noise_budget",
                         {{"T", 330.0},
                          {"NF", 9.5},
                          {"fs", 5e6},
                          {"N", 128},
                          {"Pt", 7.0},
                          {"G", 6.5},
                          {"H", 0.8},
                          {"f", 79e9},
                          {"refl_db", {-3.25}}},
                         {{"noise_psd_dbm_hz", psd},
                          {"noise_nyquist_band_dbm", psd + 10.0 * std::log10(2.5e6)},
                          {"noise_per_bin_dbm_rect", bin},
                          {"enbw_bins_blackman", enbw},
                          {"mirror_received_dbm", mirror},
                          {"snr_per_chirp_rect_db_refl_-3.25", mirror - 3.25 - bin}},
                         {{"db", 0.01}}));
}

TEST_CASE("quantising with other bits costs six decibels each", "[validate][F07]") {
    for (const int bits : {9, 14})
        check_passes(case_of("F07_quantisation", {{"bits", bits}, {"tone", "full scale"}},
                             {{"sqnr_formula_db", 6.0206 * bits + 1.7609},
                              {"sqnr_simulated_midrise_db", 6.0206 * bits + 1.7609}},
                             {{"db", 0.15}}));
}

TEST_CASE("phase noise of points of a band is that of their neighbours", "[validate][F08]") {
    const Json tolerance{{"db", 0.01}, {"rel", 1e-3}};
    Json document =
        case_of("F08_phase_noise",
                {{"R_m", 1.3}, {"offset_hz", 2e5}, {"L_1MHz_dbc_hz", -95.0}, {"slope_db_dec", -30}},
                {{"L_tx_dbc_hz", -95.0 + 30.0 * std::log10(5.0)}}, tolerance);
    const double tau = 2.0 * 1.3 / 299792458.0;
    double sum = 0.0;
    for (double f = 1e4 + 5.0; f < 3e6; f += 10.0)
        sum += 10.0 * 2.0 * std::pow(10.0, -9.5) * std::pow(f / 1e6, -3.0) * 4.0 *
               std::pow(std::sin(pi * f * tau), 2);
    document["points"].push_back({{"inp", {{"R_m", 1.3}, {"band_hz", {1e4, 3e6}}}},
                                  {"expect", {{"residual_rms_rad", std::sqrt(sum)}}}});
    const CaseVerdict verdict = validated(document);
    CHECK(verdict.verdict() == Verdict::pass);
    CHECK(verdict.points.size() == 2);
}

TEST_CASE("another corner is judged by the analog filter and shown as sampled", "[validate][F09]") {
    Json levels = Json::array(), phases = Json::array();
    for (int k = 3; k <= 40; ++k) {
        const C jx(0.0, k * 8e6 / 512 / 1.7e6);
        const C h = std::pow(jx / (1.0 + jx), 2);
        levels.push_back(20.0 * std::log10(std::abs(h)));
        phases.push_back(std::arg(h) * 180.0 / pi);
    }
    const Json document =
        case_of("F09_if_hpf", {{"fc_hz", 1.7e6}, {"fs_hz", 8e6}, {"N", 512}},
                {{"bins_3_to_40_db", levels}, {"bins_3_to_40_phase_deg", phases}}, {{"db", 0.05}});
    check_passes(document);
    CHECK(validated(document).n_shown_only() == 38);
}

TEST_CASE("other targets obey the radar equation", "[validate][F10]") {
    const double wavelength_m = 299792458.0 / 24e9;
    const auto received = [&](double sigma_m2) {
        return 3.0 + 12.0 +
               10.0 * std::log10(wavelength_m * wavelength_m * sigma_m2 /
                                 (std::pow(4.0 * pi, 3) * std::pow(2.5, 4)));
    };
    const auto point = [&](const char* target, const Json& expect) {
        return case_of("F10_absolute_power",
                       {{"target", target},
                        {"R_m", 2.5},
                        {"Pt_dbm", 3.0},
                        {"Gt_dbi", 4.0},
                        {"Gr_dbi", 8.0},
                        {"f_hz", 24e9}},
                       expect, {{"db", 1e-6}});
    };
    const double trihedral = 4.0 * pi * std::pow(0.12, 4) / (3.0 * wavelength_m * wavelength_m);
    check_passes(point("PEC sphere a=75 mm", {{"Pr_dbm", received(pi * 0.075 * 0.075)},
                                              {"sigma_m2", pi * 0.075 * 0.075}}));
    check_passes(point("triangular trihedral a=12 cm", {{"Pr_dbm", received(trihedral)}}));
    check_passes(point(
        "infinite mirror",
        {{"Pr_dbm", 15.0 + 20.0 * std::log10(wavelength_m / (20.0 * pi))}, {"sigma_m2", nullptr}}));
    for (const char* target : {"teapot", "PEC sphere", "PEC sphere a=3 parsec"})
        CHECK(validated(point(target, {{"Pr_dbm", 0.0}})).verdict() == Verdict::not_computable);
}

}  // namespace
}  // namespace specula
