#include "tools/likeness/likeness.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"
#include "sim/simulate.hpp"
#include "tools/likeness/calibration.hpp"

namespace specula {

namespace {

constexpr std::size_t most_chirps = 512;

/// What the board alone gives, without noise and rounding.
std::vector<double> board_chirp(const Radar& radar, const BeatSignal& leakage, int rx) {
    const ReceiverChain chain(radar);
    const ReceiveChannel& channel = radar.rx[static_cast<std::size_t>(rx)];
    const Complex factor = chain.signal_lsb() * std::conj(feed_factor(channel));
    std::vector<double> beat;
    for (int i = 0; i < leakage.n_samples; ++i)
        beat.push_back((factor * leakage.of_rx(rx)[i]).real());
    std::vector<double> chirp = chain.settled(beat);
    const auto before = static_cast<std::size_t>(std::max(0, -radar.chirp.settle_samples()));
    for (std::size_t n = before; n < chirp.size(); ++n) chirp[n] += channel.dc_offset_lsb;
    for (std::size_t n = 0; n < chain.start_up().size(); ++n)
        chirp[n] += channel.start_up_lsb * chain.start_up()[n];
    return chirp;
}

/// The chirp that shows the room.
std::vector<double> room_chirp(const ChirpSeries& series, int rx) {
    const std::int16_t* codes = series.chirp(series.n_chirps() / 2, rx);
    return {codes, codes + series.n_samples};
}

/// The room's tones: what one chirp holds besides the board's.
std::vector<FittedTone> room_of(const ChirpSeries& series, const Radar& radar, int rx) {
    const auto leakage = dechirp(leakage_channel(radar, {}), radar.chirp);
    const std::vector<double> codes = room_chirp(series, rx);
    std::vector<double> rest = board_chirp(radar, leakage, rx);
    for (std::size_t n = 0; n < rest.size(); ++n) rest[n] = codes[n] - rest[n];
    return ChirpFit(radar)
        .fit(rest, {.nearest_m = CalibrationSettings{}.leakage_reach_m,
                    .farthest_m = radar.chirp.max_range_m(),
                    .most_tones = 96,
                    .least_share = 1e-7,
                    .noise_lsb = 1.0})
        .tones;
}

BeatSignal room_beat(const ChirpSeries& series, const Radar& radar) {
    const ChirpFit fit(radar);
    const double signal_lsb = ReceiverChain(radar).signal_lsb();
    BeatSignal beat{.n_rx = series.n_rx, .n_samples = comb_of(radar.chirp).n, .analytic = {}};
    for (int rx = 0; rx < series.n_rx; ++rx) {
        std::vector<Complex> sum(static_cast<std::size_t>(beat.n_samples));
        for (const FittedTone& tone : room_of(series, radar, rx)) {
            const auto one = fit.beat_of(tone);
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one[i];
        }
        const Complex feed = std::conj(feed_factor(radar.rx[static_cast<std::size_t>(rx)]));
        for (const Complex& sample : sum) beat.analytic.push_back(sample / (signal_lsb * feed));
    }
    return beat;
}

ChirpSeries simulated_like(const ChirpSeries& first_half, const Radar& given, std::size_t n_chirps,
                           std::uint64_t seed) {
    Radar radar = given;
    radar.chirps_per_frame = 1;
    const ReceiverInput input{.echo = room_beat(first_half, radar),
                              .still = dechirp(leakage_channel(radar, {}), radar.chirp)};
    const ReceiverChain chain(radar);
    ChirpSeries series{first_half.n_rx, first_half.n_samples, {}};
    for (std::size_t i = 0; i < n_chirps; ++i) {
        FrameState state;
        state.draw = {.seed = seed, .purpose = "likeness", .item = static_cast<std::uint32_t>(i)};
        Stream noise(
            {.seed = seed, .purpose = "thermal noise", .item = static_cast<std::uint32_t>(i)});
        const AdcFrame frame = chain.receive(input, state, noise);
        series.codes.insert(series.codes.end(), frame.codes.begin(), frame.codes.end());
    }
    return series;
}

std::vector<double> sorted_codes(const ChirpSeries& series, int rx) {
    std::vector<double> codes;
    for (std::size_t i = 0; i < series.n_chirps(); ++i)
        codes.insert(codes.end(), series.chirp(i, rx), series.chirp(i, rx) + series.n_samples);
    std::sort(codes.begin(), codes.end());
    return codes;
}

Portrait portrait_of(const ChirpSeries& series, const Radar& radar, int rx) {
    Portrait portrait;
    portrait.mean_chirp = series.mean_chirp(rx);
    portrait.mean_spectrum = mean_spectrum_lsb(series, rx);
    portrait.leakage = amplitude_spectrum_lsb(portrait.mean_chirp);
    portrait.noise = noise_per_bin_lsb(series, rx, first_settled_sample(radar.chirp));
    portrait.codes = sorted_codes(series, rx);
    return portrait;
}

std::vector<double> in_db(const std::vector<double>& amplitudes) {
    std::vector<double> db;
    for (const double a : amplitudes) db.push_back(20.0 * std::log10(std::max(a, 1e-3)));
    return db;
}

std::vector<double> shares(const std::vector<double>& codes, const LikenessCurves& axis,
                           std::size_t n_steps) {
    std::vector<double> histogram(n_steps);
    for (const double code : codes) {
        const double step = (code - axis.histogram_begin_lsb) / axis.histogram_step_lsb;
        const auto at =
            static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(n_steps - 1)));
        histogram[at] += 1.0 / static_cast<double>(codes.size());
    }
    return histogram;
}

LikenessCurves curves_of(const Portrait& recorded, const Portrait& simulated) {
    constexpr std::size_t n_steps = 50;
    LikenessCurves curves;
    curves.mean_chirp = {recorded.mean_chirp, simulated.mean_chirp};
    curves.spectrum_db = {in_db(recorded.mean_spectrum), in_db(simulated.mean_spectrum)};
    curves.noise_lsb = {recorded.noise, simulated.noise};
    curves.histogram_begin_lsb = recorded.codes.front();
    curves.histogram_step_lsb =
        std::max(1.0, (recorded.codes.back() - recorded.codes.front() + 1.0) / n_steps);
    curves.histogram = {shares(recorded.codes, curves, n_steps),
                        shares(simulated.codes, curves, n_steps)};
    return curves;
}

}  // namespace

Likeness compare_with_recording(const ChirpSeries& recording, const Radar& radar,
                                std::uint64_t seed, std::atomic<std::size_t>* done) {
    const std::size_t half = recording.n_chirps() / 2;
    const ChirpSeries first = recording.part(0, half);
    const ChirpSeries judged =
        recording.part(half, std::min(recording.n_chirps(), half + most_chirps));
    const ChirpSeries simulated = simulated_like(first, radar, judged.n_chirps(), seed);
    Likeness likeness;
    likeness.n_chirps = judged.n_chirps();
    std::vector<Portrait> real, made;
    for (int rx = 0; rx < recording.n_rx; ++rx) {
        real.push_back(portrait_of(judged, radar, rx));
        real.back().room_chirp = amplitude_spectrum_lsb(room_chirp(first, rx));
        made.push_back(portrait_of(simulated, radar, rx));
        likeness.curves.push_back(curves_of(real.back(), made.back()));
        if (done != nullptr) ++*done;
    }
    likeness.rows = likeness_rows(real, made, radar);
    return likeness;
}

}  // namespace specula
