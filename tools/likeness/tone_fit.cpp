#include "tools/likeness/tone_fit.hpp"

#include <cmath>
#include <tuple>

#include "sim/adc/start_up.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr double grid_bins = 0.125;
constexpr double nearest_bins = 0.5;  // nearer ones are not told from the offset
constexpr std::size_t few_tones = 8;
constexpr double apart_bins = 0.3;  // nearer pairs explain little more, by cancelling each other

Radar with_pulse(Radar radar) {
    for (ReceiveChannel& rx : radar.rx) rx.start_up_lsb = 1.0;
    return radar;
}

/// Whether a tone there is told apart from all others but number `except`.
bool stands_apart(double range_m, const std::vector<double>& ranges_m, std::size_t except,
                  double least_m) {
    for (std::size_t i = 0; i < ranges_m.size(); ++i)
        if (i != except && std::abs(range_m - ranges_m[i]) < least_m) return false;
    return true;
}

double energy(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value * value;
    return sum;
}

}  // namespace

ChirpFit::ChirpFit(const Radar& radar) : radar_(radar), chain_(with_pulse(radar)) {}

std::vector<double> ChirpFit::seen(const std::vector<double>& beat) const {
    return chain_.settled(beat);
}

std::vector<Complex> ChirpFit::beat_of(const FittedTone& tone) const {
    const FrequencyComb comb = comb_of(radar_.chirp);
    std::vector<Complex> beat;
    for (int i = 0; i < comb.n; ++i) {
        const double turns = comb.at(i) / speed_of_light_m_s * 2.0 * tone.range_m;
        beat.push_back(
            std::polar(tone.amplitude_lsb, two_pi * (turns - std::floor(turns)) - tone.phase_rad));
    }
    return beat;
}

ChirpFit::Pair ChirpFit::pair_at(double range_m) const {
    std::vector<double> cosine, sine;
    for (const Complex& sample : beat_of({.range_m = range_m, .amplitude_lsb = 1.0})) {
        cosine.push_back(sample.real());
        sine.push_back(sample.imag());
    }
    return {seen(cosine), seen(sine)};
}

Columns ChirpFit::base_columns(const std::vector<Complex>* echo) const {
    const auto n_samples = static_cast<std::size_t>(radar_.chirp.n_samples);
    const auto before = static_cast<std::size_t>(std::max(0, -radar_.chirp.settle_samples()));
    std::vector<double> offset(n_samples, 1.0), pulse = chain_.start_up();
    std::fill_n(offset.begin(), before, 0.0);
    Columns columns{offset};
    if (shows_start_up()) {
        pulse.resize(n_samples, 0.0);
        columns.push_back(pulse);
    }
    if (echo != nullptr) {
        std::vector<double> real, minus_imaginary;
        for (const Complex& sample : *echo) {
            real.push_back(sample.real());
            minus_imaginary.push_back(-sample.imag());
        }
        columns.push_back(seen(real));
        columns.push_back(seen(minus_imaginary));
    }
    return columns;
}

Columns ChirpFit::with_tones(Columns columns, const std::vector<double>& ranges_m) const {
    for (const double range_m : ranges_m) {
        Pair pair = pair_at(range_m);
        columns.push_back(std::move(pair.in_phase));
        columns.push_back(std::move(pair.quadrature));
    }
    return columns;
}

std::vector<double> ChirpFit::find_ranges(const Columns& base, const std::vector<double>& observed,
                                          const ToneSearch& search) const {
    const double step_m = grid_bins * radar_.chirp.bin_m();
    const double nearest_m = std::max(search.nearest_m, nearest_bins * radar_.chirp.bin_m());
    std::vector<Pair> grid;
    for (double range_m = nearest_m; range_m <= search.farthest_m; range_m += step_m)
        grid.push_back(pair_at(range_m));
    const auto range_of = [&](std::size_t i) {
        return nearest_m + static_cast<double>(i) * step_m;
    };
    // The largest of many chance peaks of noise: 2 ln n times its variance, per pair of columns.
    const double chance =
        search.noise_lsb * search.noise_lsb * 4.0 * std::log(static_cast<double>(observed.size()));
    const double least_gain = std::max(chance, search.least_share * energy(observed));
    std::vector<double> ranges_m;
    while (static_cast<int>(ranges_m.size()) < search.most_tones) {
        const Columns columns = with_tones(base, ranges_m);
        ExplainedSpace space;
        for (const auto& column : columns) space.add(column);
        const auto rest = unexplained(columns, least_squares(columns, observed), observed);
        double best = 0.0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < grid.size(); ++i) {
            if (!stands_apart(range_of(i), ranges_m, ranges_m.size(),
                              apart_bins * radar_.chirp.bin_m()))
                continue;
            const double gain = space.gain(grid[i].in_phase, grid[i].quadrature, rest);
            if (gain > best) best = gain, at = i;
        }
        if (best <= least_gain) break;
        ranges_m.push_back(range_of(at));
        // A tone off its place leaves what the next would be taken for. Of many tones only the
        // latest is moved now.
        const std::size_t first = ranges_m.size() <= few_tones ? 0 : ranges_m.size() - 1;
        refine(base, observed, first, ranges_m);
    }
    return ranges_m;
}

void ChirpFit::refine(const Columns& base, const std::vector<double>& observed, std::size_t first,
                      std::vector<double>& ranges_m) const {
    Columns columns = with_tones(base, ranges_m);
    const auto misfit = [&] {
        return energy(unexplained(columns, least_squares(columns, observed), observed));
    };
    double least = misfit();
    for (double step_m = 0.5 * grid_bins * radar_.chirp.bin_m(); step_m > 5e-6; step_m *= 0.5)
        for (std::size_t i = first; i < ranges_m.size(); ++i) {
            const std::size_t column = base.size() + 2 * i;
            for (const double moved_m : {ranges_m[i] - step_m, ranges_m[i] + step_m}) {
                if (moved_m < nearest_bins * radar_.chirp.bin_m() ||
                    !stands_apart(moved_m, ranges_m, i, apart_bins * radar_.chirp.bin_m()))
                    continue;
                const auto kept = std::pair(columns[column], columns[column + 1]);
                Pair pair = pair_at(moved_m);
                columns[column] = std::move(pair.in_phase);
                columns[column + 1] = std::move(pair.quadrature);
                const double now = misfit();
                if (now < least) {
                    least = now;
                    ranges_m[i] = moved_m;
                    break;
                }
                std::tie(columns[column], columns[column + 1]) = kept;
            }
        }
}

FittedChannel ChirpFit::fit(const std::vector<double>& chirp, const ToneSearch& search,
                            const std::vector<Complex>* echo) const {
    const std::vector<double>& observed = chirp;
    const Columns base = base_columns(echo);
    const std::vector<double> ranges_m = find_ranges(base, observed, search);
    const Columns columns = with_tones(base, ranges_m);
    const auto found = least_squares(columns, observed);
    FittedChannel channel;
    channel.dc_lsb = found[0];
    ExplainedSpace others;
    for (std::size_t c = 1; c < columns.size(); ++c) others.add(columns[c]);
    std::size_t next = 1;
    if (shows_start_up()) channel.start_up_lsb = found[next++];
    if (echo != nullptr) {
        channel.echo_factor = Complex(found[next], found[next + 1]);
        next += 2;
    }
    for (std::size_t i = 0; i < ranges_m.size(); ++i, next += 2) {
        const Complex wave(found[next], found[next + 1]);
        channel.tones.push_back(
            {.range_m = ranges_m[i], .amplitude_lsb = std::abs(wave), .phase_rad = std::arg(wave)});
    }
    channel.residual_lsb = std::sqrt(energy(unexplained(columns, found, observed)) /
                                     static_cast<double>(observed.size()));
    channel.dc_error_lsb =
        std::hypot(channel.residual_lsb, search.noise_lsb) / others.length_beyond(columns[0]);
    return channel;
}

double start_up_fraction(const Radar& radar, const std::vector<std::vector<double>>& chirps) {
    const int before = -radar.chirp.settle_samples();
    if (before < 2) return radar.receiver.start_up_fraction;
    const int latency = radar.chirp.filter_latency_samples;
    double least = INFINITY, best = radar.receiver.start_up_fraction;
    for (double fraction = -0.45; fraction < 0.455; fraction += 0.005) {
        const auto ringing = start_up_ringing({.latency_samples = latency, .fraction = fraction});
        double misfit = 0.0;
        for (const auto& chirp : chirps) {
            std::vector<double> column, observed;
            for (int n = std::max(0, before - latency); n <= before; ++n) {
                column.push_back(ringing[static_cast<std::size_t>(n - before + latency)]);
                observed.push_back(chirp[static_cast<std::size_t>(n)]);
            }
            misfit += energy(unexplained({column}, least_squares({column}, observed), observed));
        }
        if (misfit < least) least = misfit, best = fraction;
    }
    return best;
}

}  // namespace specula
