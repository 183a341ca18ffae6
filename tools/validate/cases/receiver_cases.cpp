#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/adc/high_pass.hpp"
#include "sim/adc/receiver_chain.hpp"
#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// A tone through the whole receiver, without noise, as large as the codes of the ADC reach.
///
/// The codes lie from -2^(bits-1) to 2^(bits-1) - 1, half an LSB low, so the tone is set half an
/// LSB low too: then it meets both ends, as a mid-rise quantiser's would.
double simulated_sqnr_db(int bits) {
    constexpr int n_samples = 1 << 16;
    constexpr double cycles_per_sample = 0.1180339887498949;  // golden: phases fill the circle
    Radar radar;
    radar.receiver = {.gain_db = 0.0,
                      .noise_figure_db = -1000.0,  // none
                      .high_pass_hz = 0.0,
                      .full_scale_dbm = 0.0,
                      .adc_bits = bits};
    radar.tx_power_dbm = 0.0;
    radar.rx.front().dc_offset_lsb = -0.5;
    radar.chirp.n_samples = n_samples;
    radar.chirp.skip_samples = radar.chirp.filter_latency_samples = 0;
    BeatSignal tone{.n_rx = 1, .n_samples = n_samples, .analytic = {}};
    for (int i = 0; i < n_samples; ++i)
        tone.analytic.push_back(std::polar(1.0, two_pi * cycles_per_sample * i));
    const BeatSignal silence{.n_rx = 1,
                             .n_samples = n_samples,
                             .analytic = std::vector<Complex>(static_cast<std::size_t>(n_samples))};
    Stream unused({.seed = 1, .purpose = "quantisation case"});
    const AdcFrame frame =
        ReceiverChain(radar).receive({.echo = tone, .still = silence}, FrameState{}, unused);
    double error = 0.0;
    const double amplitude_lsb = radar.adc_full_scale_lsb();
    for (std::size_t i = 0; i < frame.codes.size(); ++i)
        error += std::pow(frame.codes[i] - (amplitude_lsb * tone.analytic[i].real() - 0.5), 2);
    return power_db(0.5 * amplitude_lsb * amplitude_lsb * n_samples / error);
}

/// A high-pass as the simulator runs it.
struct FilterProbe {
    double corner_hz;
    double rate_hz;
};

/// Its response at some frequencies, from its answer to a single 1.
std::vector<Complex> responses(const FilterProbe& probe, const std::vector<double>& frequency_hz) {
    HighPass filter(probe.corner_hz, probe.rate_hz);
    const double settled = 12.0 * probe.rate_hz / probe.corner_hz;  // fallen to exp(-75)
    std::vector<double> answer{filter.step(1.0)};
    while (static_cast<double>(answer.size()) < settled) answer.push_back(filter.step(0.0));
    std::vector<Complex> found;
    for (const double f : frequency_hz) {
        const Complex turn = std::polar(1.0, -two_pi * f / probe.rate_hz);
        Complex sum = 0.0;
        for (std::size_t i = answer.size(); i-- > 0;) sum = sum * turn + answer[i];
        found.push_back(sum);
    }
    return found;
}

/// "bins_1_to_24_db" or "bins_1_to_24_phase_deg".
struct ResponseName {
    int first = 0, last = 0;
    bool is_phase = false;
};
std::optional<ResponseName> read_response_name(const std::string& name) {
    ResponseName bins;
    int end = 0;
    char what[16] = "";
    if (std::sscanf(name.c_str(), "bins_%d_to_%d_%15[a-z_]%n", &bins.first, &bins.last, what,
                    &end) != 3 ||
        name.size() != static_cast<std::size_t>(end))
        return std::nullopt;
    bins.is_phase = std::string(what) == "phase_deg";
    if (bins.first < 0 || bins.last < bins.first) return std::nullopt;
    return bins.is_phase || std::string(what) == "db" ? std::optional(bins) : std::nullopt;
}

}  // namespace

std::vector<Quantity> quantisation_point(const CasePoint& point) {
    const int bits = point.inp.count("bits", Range::between(1.0, 64.0));
    const int n_samples = point.inp.count_or("N", 256, Range::at_least(2.0));
    if (point.inp.has("tone") && lower_case(point.inp.text("tone")) != "full scale")
        throw NotComputable("does not know another tone than one of full scale");
    const double formula_db = 6.0206 * bits + 1.7609;
    Comparison compare(point);
    compare.level("sqnr_formula_db", formula_db, "db");
    compare.level("fft_bin_sqnr_db", formula_db + power_db(0.5 * n_samples), "db");
    if (compare.wants("sqnr_simulated_midrise_db")) {
        if (bits < 2 || bits > 16) throw NotComputable("has ADCs of 2 to 16 bits only");
        compare.level("sqnr_simulated_midrise_db", simulated_sqnr_db(bits), "db");
    }
    return compare.finish();
}

std::vector<Quantity> high_pass_point(const CasePoint& point) {
    point.inp.describe({"model"});
    const double rate_hz = point.inp.number("fs_hz", Range::above(0.0));
    const double corner_hz =
        point.inp.number("fc_hz", Range::between(1e-5 * rate_hz, 1e3 * rate_hz));
    const int n = point.inp.count("N", Range::between(2.0, most_samples));
    const double tolerance_db = point.tolerance.number("db", Range::inside(0.0, 3.0));
    // An error of that level, turned by a quarter.
    const double tolerance_deg = std::asin(std::pow(10.0, tolerance_db / 20.0) - 1.0) * 180.0 / pi;
    // The case defines the analog filter, phase included: the simulator's code is judged at a rate
    // at which sampling costs nothing. At the ADC's rate, which bends the phase, its level is
    // shown.
    const double fine_hz = std::max(256.0 * corner_hz, 1.25 * rate_hz);
    Comparison compare(point);
    for (const std::string& name : point.expect.names()) {
        const auto bins = read_response_name(name);
        if (!bins || bins->last > n / 2) continue;
        std::vector<double> frequency_hz;
        for (int k = bins->first; k <= bins->last; ++k) frequency_hz.push_back(k * rate_hz / n);
        const auto found = [&](double filter_rate_hz) {
            std::vector<double> values;
            for (const Complex& h : responses({corner_hz, filter_rate_hz}, frequency_hz))
                values.push_back(bins->is_phase ? phase_deg(h) : amplitude_db(h));
            return values;
        };
        if (bins->is_phase)
            compare.phases(name, found(fine_hz), tolerance_deg);
        else
            compare.absolute(name, found(fine_hz), "db", "dB");
        if (!bins->is_phase && corner_hz < 0.5 * rate_hz)
            compare.show(name, "at the ADC's rate", found(rate_hz), "dB");
    }
    return compare.finish();
}

}  // namespace specula
