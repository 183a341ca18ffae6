#include "tools/likeness/calibration.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/link_budget.hpp"

namespace specula {

namespace {

constexpr double rounding_lsb2 = 1.0 / 12.0;
constexpr int quiet_width = 7;  // bins
constexpr double most_saturated = 0.01;  // a fit takes codes for what was received

/// The quietest stretch of bins between the leakage and the end of the filter's pass band.
int quietest_bin(const std::vector<double>& noise_lsb, const Radar& radar, double reach_m) {
    const int first = static_cast<int>(std::ceil(radar.chirp.bin_of(reach_m))) + 2;
    const int end = std::max(first + quiet_width + 1,
                             static_cast<int>(radar.chirp.pass_band * radar.chirp.n_samples));
    double least = INFINITY;
    int best = first;
    for (int bin = first;
         bin + quiet_width <= std::min<int>(end, static_cast<int>(noise_lsb.size())); ++bin) {
        double sum = 0.0;
        for (int k = 0; k < quiet_width; ++k) sum += noise_lsb[static_cast<std::size_t>(bin + k)];
        if (sum < 0.97 * least) least = sum, best = bin;
    }
    return best;
}

/// Two powers, before and behind the high-pass, from noise over bins; neither below zero.
void split_noise(const std::vector<double>& noise_lsb, const Radar& radar, NoiseFit& fit) {
    // Bins that move hold more than noise, and beyond the pass band the filter cuts it.
    const double moving_lsb = 1.6 * fit.quiet_lsb;
    const auto last = static_cast<std::size_t>(radar.chirp.pass_band * radar.chirp.n_samples);
    Columns columns(2);
    std::vector<double> observed;
    for (std::size_t bin = 2; bin < std::min(last, noise_lsb.size()); ++bin) {
        if (noise_lsb[bin] > moving_lsb) continue;
        const double beat_hz =
            static_cast<double>(bin) * radar.chirp.sample_rate_hz / radar.chirp.n_samples;
        columns[0].push_back(std::pow(10.0, 0.1 * radar.receiver.high_pass_db(beat_hz)));
        columns[1].push_back(1.0);
        observed.push_back(noise_lsb[bin] * noise_lsb[bin] - rounding_lsb2);
    }
    const auto mean = [&](const std::vector<double>& values) {
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    };
    auto power = least_squares(columns, observed);
    if (power[1] < 0.0) power = {mean(observed) / mean(columns[0]), 0.0};
    if (power[0] < 0.0) power = {0.0, mean(observed)};
    fit.before_lsb = std::sqrt(std::max(0.0, power[0]));
    fit.behind_lsb = std::sqrt(std::max(0.0, power[1]));
}

NoiseFit fit_noise(const ChirpSeries& series, int rx, const Radar& radar, double reach_m) {
    const auto noise_lsb = noise_per_bin_lsb(series, rx, first_settled_sample(radar.chirp));
    NoiseFit fit;
    fit.first_quiet_bin = quietest_bin(noise_lsb, radar, reach_m);
    fit.last_quiet_bin = fit.first_quiet_bin + quiet_width - 1;
    for (int bin = fit.first_quiet_bin; bin <= fit.last_quiet_bin; ++bin)
        fit.quiet_lsb += std::pow(noise_lsb[static_cast<std::size_t>(bin)], 2) / quiet_width;
    fit.quiet_lsb = std::sqrt(fit.quiet_lsb);
    split_noise(noise_lsb, radar, fit);
    return fit;
}

/// Puts the mean of the receivers' noise into the radar.
void set_noise(Radar& radar, const std::vector<NoiseFit>& noise) {
    double before = 0.0, behind = 0.0;
    for (const NoiseFit& fit : noise) {
        before += fit.before_lsb * fit.before_lsb / static_cast<double>(noise.size());
        behind += fit.behind_lsb * fit.behind_lsb / static_cast<double>(noise.size());
    }
    const double stated_lsb = ReceiverChain(radar).noise_lsb();
    if (before > 0.0)
        radar.receiver.noise_figure_db =
            std::max(0.0, radar.receiver.noise_figure_db + 10.0 * std::log10(before) -
                              20.0 * std::log10(stated_lsb));
    else
        radar.receiver.noise_figure_db = 0.0;
    radar.receiver.adc_noise_lsb = std::sqrt(behind);
}

/// Codes that no scene explains: beyond the ADC, at its ends, or always the same.
void check_codes(const ChirpSeries& series, const Radar& radar) {
    const auto full = static_cast<int>(radar.adc_full_scale_lsb());
    std::size_t at_ends = 0;
    for (const std::int16_t code : series.codes) {
        if (code < -full || code >= full)
            throw InputError(format("code {}: is beyond the {} bits of radar {}; name the radar "
                                    "that it was made with",
                                    code, radar.receiver.adc_bits, radar.name));
        if (code == -full || code == full - 1) ++at_ends;
    }
    const double share = static_cast<double>(at_ends) / static_cast<double>(series.codes.size());
    if (share > most_saturated)
        throw InputError(format("{:.1f} % of the codes are at the ends of the ADC; record with "
                                "less gain or without what reflects so much",
                                100.0 * share));
    for (int rx = 0; rx < series.n_rx; ++rx) {
        const std::int16_t first = series.chirp(0, rx)[0];
        bool changes = false;
        for (std::size_t i = 0; i < series.n_chirps() && !changes; ++i)
            changes = !std::all_of(series.chirp(i, rx), series.chirp(i, rx) + series.n_samples,
                                   [&](std::int16_t code) { return code == first; });
        if (!changes)
            throw InputError(format("RX {}: every code is {}; is the receiver on?", rx, first));
    }
}

void check_fits(const ChirpSeries& series, const Radar& radar) {
    if (series.n_rx != static_cast<int>(radar.rx.size()) ||
        series.n_samples != radar.chirp.n_samples)
        throw InputError(format(
            "the recording has {} RX and {} samples, radar {} has {} and {}; "
            "name the radar that it was made with",
            series.n_rx, series.n_samples, radar.name, radar.rx.size(), radar.chirp.n_samples));
    if (radar.receiver.complex_samples)
        throw InputError(
            format("radar {} gives I and Q; calibration takes real samples only", radar.name));
    if (radar.n_tx() > 1)
        throw InputError(format("radar {} has {} TX; calibrate with a recording of one", radar.name,
                                radar.n_tx()));
    check_codes(series, radar);
    if (series.n_chirps() < 3)
        throw InputError(
            format("the recording has {} chirps; record three or more, so that noise "
                   "shows as their difference",
                   series.n_chirps()));
}

Leakage leakage_of(const FittedTone& tone, int rx, const Radar& radar) {
    // The feed is the receiver's: what is written is the wave before it.
    const Complex wave = std::polar(tone.amplitude_lsb, tone.phase_rad) /
                         feed_factor(radar.rx[static_cast<std::size_t>(rx)]);
    return {.rx = rx,
            .tx = {},
            .range_m = tone.range_m,
            .level_dbm = power_of_lsb_dbm(radar, std::abs(wave)) - radar.receiver.gain_db,
            .phase_rad = std::arg(wave)};
}

}  // namespace

Calibration calibrate(const ChirpSeries& series, const Radar& given, const BeatSignal* echo,
                      const CalibrationSettings& settings, std::atomic<std::size_t>* done) {
    check_fits(series, given);
    Calibration result;
    result.radar = given;
    result.n_chirps = series.n_chirps();
    result.knows_gain = echo != nullptr;
    Radar& radar = result.radar;
    std::vector<std::vector<double>> means;
    for (int rx = 0; rx < series.n_rx; ++rx) means.push_back(series.mean_chirp(rx));
    radar.receiver.start_up_fraction = start_up_fraction(radar, means);
    radar.leakage.clear();
    const ChirpFit fit(radar);
    const double signal_lsb = ReceiverChain(radar).signal_lsb();
    for (int rx = 0; rx < series.n_rx; ++rx) {
        result.noise.push_back(fit_noise(series, rx, radar, settings.leakage_reach_m));
        const double mean_noise_lsb =
            result.noise.back().quiet_lsb / std::sqrt(static_cast<double>(series.n_chirps()));
        std::vector<Complex> known;
        if (echo != nullptr)
            for (int i = 0; i < echo->n_samples; ++i)
                known.push_back(signal_lsb * echo->of_rx(rx)[i]);
        // First the room and the board together, then each by its range.
        const FittedChannel all =
            fit.fit(means[static_cast<std::size_t>(rx)],
                    {.farthest_m = radar.chirp.max_range_m(),
                     .most_tones = settings.most_leakage_tones + settings.most_room_tones,
                     .noise_lsb = mean_noise_lsb},
                    echo == nullptr ? nullptr : &known);
        FittedChannel own = all;
        own.tones.clear();
        result.room.emplace_back();
        for (const FittedTone& tone : all.tones)
            (tone.range_m <= settings.leakage_reach_m ? own.tones : result.room.back())
                .push_back(tone);
        ReceiveChannel& channel = radar.rx[static_cast<std::size_t>(rx)];
        channel.dc_offset_lsb = own.dc_lsb;
        if (fit.shows_start_up()) channel.start_up_lsb = own.start_up_lsb;
        if (echo != nullptr) {
            // The beat is the wave's conjugate, and so is its feed.
            const Complex feed = std::conj(own.echo_factor);
            channel.inverted = false;
            channel.gain_db = 20.0 * std::log10(std::abs(feed));
            channel.phase_rad = std::arg(feed);
        }
        for (const FittedTone& tone : own.tones)
            radar.leakage.push_back(leakage_of(tone, rx, radar));
        result.channels.push_back(own);
        if (done != nullptr) ++*done;
    }
    set_noise(radar, result.noise);
    return result;
}

}  // namespace specula
