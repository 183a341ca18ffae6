#include "sim/adc/receiver_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/adc/start_up.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/kernels.hpp"

namespace specula {

namespace {

/// kTF over half the sample rate, in dBm.
double noise_power_dbm(const Receiver& receiver, double sample_rate_hz) {
    const double watt = boltzmann_j_k * receiver.temperature_k * 0.5 * sample_rate_hz;
    return 10.0 * std::log10(watt * 1e3) + receiver.noise_figure_db;
}

/// Real sampling folds the noise of a tone's power, A^2/2; with two rails a tone's is A^2.
double noise_deviation_lsb(const Radar& radar) {
    const double tone_lsb =
        radar.amplitude_lsb(noise_power_dbm(radar.receiver, radar.chirp.sample_rate_hz));
    return radar.receiver.complex_samples ? tone_lsb : tone_lsb / std::numbers::sqrt2;
}

/// To the nearest whole number, halves to even ones, saturating.
std::int16_t quantise(double lsb, double full_scale) {
    constexpr double rounder =
        6755399441055744.0;  // 1.5 * 2^52: sums have no bits behind the point
    const double kept = std::clamp(lsb, -full_scale, full_scale - 1.0);
    return static_cast<std::int16_t>((kept + rounder) - rounder);
}

/// std::complex looks for infinities first.
Complex times(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// The part of the filter's ringing that samples of the frame show.
std::vector<double> visible_start_up(const Radar& radar) {
    const bool any = std::any_of(radar.rx.begin(), radar.rx.end(),
                                 [](const ReceiveChannel& rx) { return rx.start_up_lsb != 0.0; });
    const int settle = radar.chirp.settle_samples();
    const int latency = radar.chirp.filter_latency_samples;
    if (!any || settle > latency) return {};
    const auto ringing = start_up_ringing(
        {.latency_samples = latency, .fraction = radar.receiver.start_up_fraction});
    std::vector<double> visible;  // sample n of the frame is n + settle after the start
    for (int n = 0; n < radar.chirp.n_samples && n + settle <= latency; ++n)
        visible.push_back(
            n + settle < -latency ? 0.0 : ringing[static_cast<std::size_t>(n + settle + latency)]);
    return visible;
}

HighPass::Corners corners_of(const Receiver& receiver) {
    const double first_hz = receiver.high_pass_hz, second_hz = receiver.second_high_pass_hz;
    return {.first_hz = first_hz, .second_hz = second_hz < 0.0 ? first_hz : second_hz};
}

StreamKey for_purpose(StreamKey key, std::string_view purpose) {
    key.purpose = purpose;
    return key;
}

}  // namespace

struct ReceiverChain::Chirp {
    TxTurn turn;
    double gain;
    const ReceiverScratch& scratch;
};

struct ReceiverChain::Rails {
    const ReceiverScratch& scratch;
    double noise_lsb;
    std::size_t draws;      ///< of noise, per rail
    std::size_t per_rx;     ///< rails: 1, or 2 of a complex receiver
    FrameCodes codes;       ///< of this chirp
    std::size_t first = 0;  ///< of those to digitise now
    std::size_t n = 0;      ///< how many of them, 1 to 4
};

ReceiverChain::ReceiverChain(const Radar& radar)
    : radar_(radar),
      signal_lsb_(radar.amplitude_lsb(radar.tx_power_dbm)),
      noise_lsb_(noise_deviation_lsb(radar)),
      ramp_noise_(radar),
      high_pass_(corners_of(radar.receiver), radar.chirp.sample_rate_hz),
      n_dark_(static_cast<std::size_t>(
          std::ceil(radar.chirp.tx_on_s * radar.chirp.sample_rate_hz - 1e-9))),
      start_up_(visible_start_up(radar)) {
    if (radar.interferer) interference_.emplace(radar, *radar.interferer);
    const FrequencyComb comb = comb_of(radar.chirp);
    for (int i = 0; i < comb.n; ++i) turns_per_m_.push_back(2.0 * comb.at(i) / speed_of_light_m_s);
}

void ReceiverChain::turn_echo(const FrameState& state, const Chirp& chirp,
                              ReceiverScratch& scratch) const {
    const double begin_s = chirp.turn.chirp * radar_.chirp.period_s();
    const auto n = turns_per_m_.size();
    for (std::size_t i = 0; i < n; ++i) {
        double away_m = state.displacement_m;
        if (!state.motion.is_rest())
            away_m += state.motion.displacement_m(begin_s + static_cast<double>(i) /
                                                                radar_.chirp.sample_rate_hz);
        scratch.turns[i] = turns_per_m_[i] * away_m;
    }
    kernels().turn(scratch.turns.data(), n, scratch.cosine.data(), scratch.sine.data());
    for (std::size_t i = 0; i < n; ++i)
        scratch.echo_turn[i] = {chirp.gain * scratch.cosine[i], chirp.gain * scratch.sine[i]};
}

void ReceiverChain::add_board(const BeatSignal& board, const FrameState& state, const Chirp& chirp,
                              int rx, std::span<Complex> beat) const {
    const Complex drift = state.board_factor.empty()
                              ? Complex(1.0)
                              : state.board_factor[static_cast<std::size_t>(rx)];
    for (int tx = 0; tx < chirp.turn.n_tx; ++tx) {
        const double weight = tx_weight(radar_.multiplexing, tx, chirp.turn);
        const Complex factor = weight * chirp.gain * drift * std::conj(feed_factor(radar_.tx(tx)));
        const Complex* leak = board.of_rx(tx * static_cast<int>(radar_.rx.size()) + rx);
        for (std::size_t i = 0; i < beat.size(); ++i) beat[i] += times(factor, leak[i]);
    }
}

void ReceiverChain::arrive(const ReceiverInput& input, const FrameState& state, const Chirp& chirp,
                           int rx, std::span<Complex> beat) const {
    const int n_rx = static_cast<int>(radar_.rx.size());
    const auto n = beat.size();
    const std::vector<Complex>& turn = chirp.scratch.echo_turn;
    const double first = tx_weight(radar_.multiplexing, 0, chirp.turn);
    const Complex* first_echo = input.echo.of_rx(rx);
    const Complex* first_still = input.still.of_rx(rx);
    for (std::size_t i = 0; i < n; ++i)
        beat[i] = first * (times(first_echo[i], turn[i]) + chirp.gain * first_still[i]);
    for (int tx = 1; tx < chirp.turn.n_tx; ++tx) {
        const double weight = tx_weight(radar_.multiplexing, tx, chirp.turn);
        if (weight == 0.0) continue;
        const Complex feed = weight * std::conj(feed_factor(radar_.tx(tx)));
        const Complex* echo = input.echo.of_rx(tx * n_rx + rx);
        const Complex* still = input.still.of_rx(tx * n_rx + rx);
        const Complex still_gain = feed * chirp.gain;
        for (std::size_t i = 0; i < n; ++i)
            beat[i] += times(feed, times(echo[i], turn[i])) + times(still_gain, still[i]);
    }
    if (input.board.n_rx > 0) add_board(input.board, state, chirp, rx, beat);
    if (!chirp.scratch.frequency_error.empty())
        RampNoise::apply(beat, chirp.scratch.frequency_error);
    const Complex feed = std::conj(feed_factor(radar_.rx[static_cast<std::size_t>(rx)]));
    if (feed != 1.0)
        for (Complex& sample : beat) sample *= feed;
    std::fill_n(beat.begin(), std::min(n_dark_, n), Complex{});
}

/// Some rails side by side: each filter's step waits for the one before, but not for the others'.
void ReceiverChain::digitise(const Rails& rails) const {
    const std::size_t first = rails.first, n = rails.n;
    const double full_scale = radar_.adc_full_scale_lsb();
    const double adc_noise_lsb = radar_.receiver.adc_noise_lsb;
    const int settle = radar_.chirp.settle_samples();
    const auto n_samples = static_cast<std::size_t>(radar_.chirp.n_samples);
    struct Rail {
        HighPass filter;
        const ReceiveChannel& channel;
        const Complex* beat;
        const double* noise;
        std::int16_t* codes;
        bool is_quadrature;
    };
    const auto rail_of = [&](std::size_t number) {
        const std::size_t rx = number / rails.per_rx;
        const bool is_quadrature = number % rails.per_rx == 1;
        const auto& codes = is_quadrature ? rails.codes.quadrature : rails.codes.in_phase;
        return Rail{high_pass_,
                    radar_.rx[rx],
                    rails.scratch.beat.data() + rx * turns_per_m_.size(),
                    rails.scratch.noise.data() + number * rails.draws,
                    codes.data() + rx * n_samples,
                    is_quadrature};
    };
    Rail side_by_side[] = {rail_of(first), rail_of(first + (n > 1 ? 1 : 0)),
                           rail_of(first + (n > 2 ? 2 : 0)), rail_of(first + (n > 3 ? 3 : 0))};
    const auto start_up = [&](const Rail& rail, int sample) {
        return static_cast<std::size_t>(sample) < start_up_.size()
                   ? rail.channel.start_up_lsb * start_up_[static_cast<std::size_t>(sample)]
                   : 0.0;
    };
    for (int sample = 0; sample < -settle; ++sample)  // the filter has no input yet but the pulse
        for (std::size_t r = 0; r < n; ++r)
            *side_by_side[r].codes++ = quantise(start_up(side_by_side[r], sample), full_scale);
    for (std::size_t i = 0; i < turns_per_m_.size(); ++i) {
        const int sample = static_cast<int>(i) - settle;
        for (std::size_t r = 0; r < n; ++r) {
            Rail& rail = side_by_side[r];
            const double arriving = rail.is_quadrature ? rail.beat[i].imag() : rail.beat[i].real();
            double value = rail.filter.step(arriving + rails.noise_lsb * *rail.noise++);
            if (sample < 0) continue;
            if (adc_noise_lsb > 0.0) value += adc_noise_lsb * *rail.noise++;
            *rail.codes++ =
                quantise(value + rail.channel.dc_offset_lsb + start_up(rail, sample), full_scale);
        }
    }
}

std::size_t ReceiverChain::codes_per_frame() const {
    return static_cast<std::size_t>(radar_.chirps_per_frame) * radar_.rx.size() *
           static_cast<std::size_t>(radar_.chirp.n_samples);
}

AdcFrame ReceiverChain::receive(const ReceiverInput& input, const FrameState& state,
                                Stream& noise) const {
    AdcFrame frame{.n_chirps = radar_.chirps_per_frame,
                   .n_rx = static_cast<int>(radar_.rx.size()),
                   .n_samples = radar_.chirp.n_samples,
                   .codes = std::vector<std::int16_t>(codes_per_frame()),
                   .quadrature = {}};
    if (radar_.receiver.complex_samples) frame.quadrature.resize(codes_per_frame());
    ReceiverScratch scratch;
    record(input, state, {noise, scratch, {frame.codes, frame.quadrature}});
    return frame;
}

void ReceiverChain::record(const ReceiverInput& input, const FrameState& state,
                           const Recording& recording) const {
    constexpr std::size_t side_by_side = 4;
    const int n_rx = static_cast<int>(radar_.rx.size()), n_tx = radar_.n_tx();
    SPECULA_EXPECT(input.echo.n_rx == n_rx * n_tx && input.still.n_rx == n_rx * n_tx);
    SPECULA_EXPECT(recording.codes.in_phase.size() == codes_per_frame());
    const double drift = std::pow(10.0, state.gain_db / 20.0);
    const auto n = turns_per_m_.size();
    const std::size_t per_rx = radar_.receiver.complex_samples ? 2 : 1;
    const std::size_t n_rails = per_rx * radar_.rx.size();
    const auto settling = static_cast<std::size_t>(std::max(0, radar_.chirp.settle_samples()));
    const std::size_t draws = radar_.receiver.adc_noise_lsb > 0.0 ? 2 * n - settling : n;
    ReceiverScratch& scratch = recording.scratch;
    for (auto* numbers : {&scratch.turns, &scratch.cosine, &scratch.sine}) numbers->resize(n);
    scratch.echo_turn.resize(n);
    scratch.beat.resize(n * radar_.rx.size());
    scratch.noise.resize(n_rails * draws);
    Stream ramp(for_purpose(state.draw, "ramp")), other(for_purpose(state.draw, "interferer"));
    Chirp chirp{
        .turn = {.chirp = 0, .n_tx = n_tx}, .gain = signal_lsb_ * drift, .scratch = scratch};
    const std::size_t per_chirp =
        codes_per_frame() / static_cast<std::size_t>(radar_.chirps_per_frame);
    for (; chirp.turn.chirp < radar_.chirps_per_frame; ++chirp.turn.chirp) {
        if (chirp.turn.chirp == 0 || !state.motion.is_rest()) turn_echo(state, chirp, scratch);
        scratch.frequency_error.clear();
        if (!ramp_noise_.is_silent()) scratch.frequency_error = ramp_noise_.draw(n, ramp);
        const double lead_s = interference_ ? interference_->draw_lead_s(other) : 0.0;
        for (int rx = 0; rx < n_rx; ++rx) {
            const auto beat = std::span(scratch.beat).subspan(static_cast<std::size_t>(rx) * n, n);
            arrive(input, state, chirp, rx, beat);
            if (interference_)
                interference_->add(
                    beat,
                    {.lead_s = lead_s,
                     .amplitude = drift * radar_.amplitude_lsb(radar_.interferer->level_dbm)},
                    other);
        }
        recording.noise.fill_normal(scratch.noise);
        const std::size_t from = static_cast<std::size_t>(chirp.turn.chirp) * per_chirp;
        Rails rails{.scratch = scratch,
                    .noise_lsb = noise_lsb_ * drift,
                    .draws = draws,
                    .per_rx = per_rx,
                    .codes = {recording.codes.in_phase.subspan(from, per_chirp),
                              per_rx == 2 ? recording.codes.quadrature.subspan(from, per_chirp)
                                          : std::span<std::int16_t>{}}};
        for (; rails.first < n_rails; rails.first += side_by_side) {
            rails.n = std::min(side_by_side, n_rails - rails.first);
            digitise(rails);
        }
    }
}

std::vector<double> ReceiverChain::settled(const std::vector<double>& beat) const {
    const int settle = radar_.chirp.settle_samples();
    std::vector<double> samples(static_cast<std::size_t>(std::max(0, -settle)), 0.0);
    HighPass filter = high_pass_;
    for (std::size_t i = 0; i < beat.size(); ++i) {
        const double value = filter.step(i < n_dark_ ? 0.0 : beat[i]);
        if (static_cast<int>(i) >= settle) samples.push_back(value);
    }
    return samples;
}

}  // namespace specula
