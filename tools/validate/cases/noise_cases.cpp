#include <cmath>
#include <cstdio>
#include <numbers>

#include "sim/adc/receiver_chain.hpp"
#include "sim/core/constants.hpp"
#include "sim/link_budget.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/phase_noise.hpp"
#include "tools/validate/formulas/spectrum.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// The radar of a noise budget: a ramp of 1 % around the frequency, no high-pass.
Radar budget_radar(const Fields& inp) {
    const int n_samples = inp.count("N", Range::between(2, most_samples));
    const double rate_hz = inp.number_of({"fs_hz", "fs"}, Range::above(0.0));
    const double centre_hz = frequency_of(inp);
    Radar radar;
    radar.chirp = {.start_hz = centre_hz * 0.995,
                   .slope_hz_s = centre_hz * 0.01 * rate_hz / n_samples,
                   .sample_rate_hz = rate_hz,
                   .n_samples = n_samples,
                   .skip_samples = 0,
                   .filter_latency_samples = 0,
                   .ramp_end_s = n_samples / rate_hz};
    radar.tx_power_dbm = inp.number("Pt");
    radar.pattern = IsotropicPattern{.gain_dbi = inp.number("G")};
    radar.receiver.noise_figure_db = inp.number("NF");
    radar.receiver.temperature_k = inp.number("T", Range::above(0.0));
    radar.receiver.high_pass_hz = 0.0;
    return radar;
}

/// Power of the ADC's noise at the RX port.
double noise_dbm(const Radar& radar) {
    const double tone_lsb = ReceiverChain(radar).noise_lsb() * std::numbers::sqrt2;
    return 20.0 * std::log10(tone_lsb / radar.amplitude_lsb(0.0));
}

}  // namespace

std::vector<Quantity> noise_budget_point(const CasePoint& point) {
    const Radar radar = budget_radar(point.inp);
    const int n = radar.chirp.n_samples;
    const double mirror_dbm =
        mirror_budget(radar, point.inp.number_of({"H", "H_m"}, Range::above(0.0))).received_dbm;
    const double band_dbm = noise_dbm(radar);
    const auto width_db = [&](const char* window) {
        return power_db(noise_bandwidth_bins(window_values(window, n)));
    };
    const auto bin_dbm = [&](const char* window) {
        return band_dbm + power_db(2.0 / n) + width_db(window);  // fs/2 holds N/2 bins
    };
    point.inp.describe({"refl_db"});
    Comparison compare(point);
    compare.level("noise_psd_dbm_hz", band_dbm - power_db(0.5 * radar.chirp.sample_rate_hz), "db");
    compare.level("noise_nyquist_band_dbm", band_dbm, "db");
    compare.level("mirror_received_dbm", mirror_dbm, "db");
    const double allowed = std::pow(10.0, 0.1 * point.tolerance.number("db")) - 1.0;
    for (const std::string& name : point.expect.names()) {
        char window[32] = "";
        double reflection_db = 0.0;
        int end = 0;
        const auto whole = [&] { return name.size() == static_cast<std::size_t>(end); };
        if (std::sscanf(name.c_str(), "noise_per_bin_dbm_%31[a-z]%n", window, &end) == 1 && whole())
            compare.level(name, bin_dbm(window), "db");
        else if (std::sscanf(name.c_str(), "enbw_bins_%31[a-z]%n", window, &end) == 1 && whole())
            compare.within(name, noise_bandwidth_bins(window_values(window, n)),
                           {allowed * point.expect.number(name), "bins"});
        else if (std::sscanf(name.c_str(), "snr_per_chirp_%31[a-z]_db_refl_%lf%n", window,
                             &reflection_db, &end) == 2 &&
                 whole())
            compare.level(name, mirror_dbm + reflection_db - bin_dbm(window), "db");
    }
    return compare.finish();
}

std::vector<Quantity> phase_noise_point(const CasePoint& point) {
    point.inp.describe({"S_phi"});
    const double delay_s = 2.0 * point.inp.number("R_m", Range::above(0.0)) / speed_of_light_m_s;
    // Points of a band leave the oscillator to their neighbours; TI's figure where none says it.
    const auto said = [&](const char* name, double usual) {
        return point.inp.has(name) ? point.inp.number(name)
                                   : point.file.agreed_number(name).value_or(usual);
    };
    const Oscillator oscillator{.at_1mhz_dbc_hz = said("L_1MHz_dbc_hz", -89.0),
                                .slope_db_per_decade = said("slope_db_dec", -20.0)};
    if (point.inp.has("band_hz")) {
        const auto band_hz = point.inp.numbers("band_hz", Range::above(0.0));
        if (band_hz.size() != 2 || band_hz[0] >= band_hz[1])
            point.inp.fail("band_hz", "no band", "give [lowest, highest]");
        constexpr double most_turns = 1e6;
        if (band_hz[1] * delay_s > most_turns)
            throw NotComputable("integrates over a million turns of f tau at most");
        Comparison compare(point);
        compare.relative(
            "residual_rms_rad",
            residual_phase_rms_rad(
                oscillator, {.low_hz = band_hz[0], .high_hz = band_hz[1], .delay_s = delay_s}),
            "rel");
        return compare.finish();
    }
    const double offset_hz = point.inp.number("offset_hz", Range::above(0.0));
    const double factor_db = range_correlation_db({.delay_s = delay_s, .offset_hz = offset_hz});
    const double level = oscillator.level_dbc_hz(offset_hz);
    Comparison compare(point);
    compare.level("range_correlation_factor_db", factor_db, "db");
    compare.level("L_tx_dbc_hz", level, "db");
    compare.level("L_residual_dbc_hz", level + factor_db, "db");
    return compare.finish();
}

}  // namespace specula
