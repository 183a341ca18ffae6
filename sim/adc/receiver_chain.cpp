#include "sim/adc/receiver_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/adc/start_up.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

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

std::int16_t quantise(double lsb, double full_scale) {
    return static_cast<std::int16_t>(
        std::clamp(std::nearbyint(lsb), -full_scale, full_scale - 1.0));
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
    std::vector<Complex> echo_turn;       ///< (sample): gain and displacement
    std::vector<double> frequency_error;  ///< (sample); empty: none
};

struct ReceiverChain::Rail {
    const ReceiveChannel& channel;
    const std::vector<Complex>& beat;
    double noise_lsb;
    bool is_quadrature;
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
    for (int i = 0; i < comb.n; ++i)
        wavenumber_rad_m_.push_back(two_pi * comb.at(i) / speed_of_light_m_s);
}

void ReceiverChain::turn_echo(const FrameState& state, Chirp& chirp) const {
    const double begin_s = chirp.turn.chirp * radar_.chirp.period_s();
    for (std::size_t i = 0; i < chirp.echo_turn.size(); ++i) {
        double away_m = state.displacement_m;
        if (!state.motion.is_rest())
            away_m += state.motion.displacement_m(begin_s + static_cast<double>(i) /
                                                                radar_.chirp.sample_rate_hz);
        chirp.echo_turn[i] = std::polar(chirp.gain, 2.0 * wavenumber_rad_m_[i] * away_m);
    }
}

void ReceiverChain::add_board(const BeatSignal& board, const FrameState& state, const Chirp& chirp,
                              int rx, std::vector<Complex>& beat) const {
    const Complex drift = state.board_factor.empty()
                              ? Complex(1.0)
                              : state.board_factor[static_cast<std::size_t>(rx)];
    for (int tx = 0; tx < chirp.turn.n_tx; ++tx) {
        const double weight = tx_weight(radar_.multiplexing, tx, chirp.turn);
        const Complex factor = weight * chirp.gain * drift * std::conj(feed_factor(radar_.tx(tx)));
        const Complex* leak = board.of_rx(tx * static_cast<int>(radar_.rx.size()) + rx);
        for (std::size_t i = 0; i < beat.size(); ++i) beat[i] += factor * leak[i];
    }
}

void ReceiverChain::arrive(const ReceiverInput& input, const FrameState& state, const Chirp& chirp,
                           int rx, std::vector<Complex>& beat) const {
    const int n_rx = static_cast<int>(radar_.rx.size());
    const auto n = beat.size();
    const double first = tx_weight(radar_.multiplexing, 0, chirp.turn);
    const Complex* first_echo = input.echo.of_rx(rx);
    const Complex* first_still = input.still.of_rx(rx);
    for (std::size_t i = 0; i < n; ++i)
        beat[i] = first * (first_echo[i] * chirp.echo_turn[i] + chirp.gain * first_still[i]);
    for (int tx = 1; tx < chirp.turn.n_tx; ++tx) {
        const double weight = tx_weight(radar_.multiplexing, tx, chirp.turn);
        if (weight == 0.0) continue;
        const Complex feed = weight * std::conj(feed_factor(radar_.tx(tx)));
        const Complex* echo = input.echo.of_rx(tx * n_rx + rx);
        const Complex* still = input.still.of_rx(tx * n_rx + rx);
        const Complex still_gain = feed * chirp.gain;
        for (std::size_t i = 0; i < n; ++i)
            beat[i] += feed * (echo[i] * chirp.echo_turn[i]) + still_gain * still[i];
    }
    if (input.board.n_rx > 0) add_board(input.board, state, chirp, rx, beat);
    if (!chirp.frequency_error.empty()) RampNoise::apply(beat, chirp.frequency_error);
    const Complex feed = std::conj(feed_factor(radar_.rx[static_cast<std::size_t>(rx)]));
    if (feed != 1.0)
        for (Complex& sample : beat) sample *= feed;
    std::fill_n(beat.begin(), std::min(n_dark_, n), Complex{});
}

void ReceiverChain::digitise(const Rail& rail, Stream& noise,
                             std::vector<std::int16_t>& codes) const {
    const ReceiveChannel& channel = rail.channel;
    const double full_scale = radar_.adc_full_scale_lsb();
    const double adc_noise_lsb = radar_.receiver.adc_noise_lsb;
    const int settle = radar_.chirp.settle_samples();
    const auto start_up = [&](int n) {
        return static_cast<std::size_t>(n) < start_up_.size()
                   ? channel.start_up_lsb * start_up_[static_cast<std::size_t>(n)]
                   : 0.0;
    };
    for (int n = 0; n < -settle; ++n)  // the filter has no input yet but the pulse
        codes.push_back(quantise(start_up(n), full_scale));
    HighPass filter = high_pass_;
    for (std::size_t i = 0; i < rail.beat.size(); ++i) {
        const double arriving = rail.is_quadrature ? rail.beat[i].imag() : rail.beat[i].real();
        double value = filter.step(arriving + rail.noise_lsb * noise.normal());
        const int n = static_cast<int>(i) - settle;
        if (n < 0) continue;
        if (adc_noise_lsb > 0.0) value += adc_noise_lsb * noise.normal();
        codes.push_back(quantise(value + channel.dc_offset_lsb + start_up(n), full_scale));
    }
}

AdcFrame ReceiverChain::receive(const ReceiverInput& input, const FrameState& state,
                                Stream& noise) const {
    const int n_rx = static_cast<int>(radar_.rx.size()), n_tx = radar_.n_tx();
    SPECULA_EXPECT(input.echo.n_rx == n_rx * n_tx && input.still.n_rx == n_rx * n_tx);
    const double drift = std::pow(10.0, state.gain_db / 20.0);
    const auto n_samples = wavenumber_rad_m_.size();
    Chirp chirp{.turn = {.chirp = 0, .n_tx = n_tx},
                .gain = signal_lsb_ * drift,
                .echo_turn = std::vector<Complex>(n_samples),
                .frequency_error = {}};
    AdcFrame frame{.n_chirps = radar_.chirps_per_frame,
                   .n_rx = n_rx,
                   .n_samples = radar_.chirp.n_samples,
                   .codes = {},
                   .quadrature = {}};
    frame.codes.reserve(static_cast<std::size_t>(frame.n_chirps) *
                        static_cast<std::size_t>(frame.n_rx) *
                        static_cast<std::size_t>(frame.n_samples));
    Stream ramp(for_purpose(state.draw, "ramp")), other(for_purpose(state.draw, "interferer"));
    std::vector<Complex> beat(n_samples);
    for (chirp.turn.chirp = 0; chirp.turn.chirp < frame.n_chirps; ++chirp.turn.chirp) {
        if (chirp.turn.chirp == 0 || !state.motion.is_rest()) turn_echo(state, chirp);
        if (!ramp_noise_.is_silent()) chirp.frequency_error = ramp_noise_.draw(n_samples, ramp);
        const double lead_s = interference_ ? interference_->draw_lead_s(other) : 0.0;
        for (int rx = 0; rx < n_rx; ++rx) {
            arrive(input, state, chirp, rx, beat);
            if (interference_)
                interference_->add(
                    beat,
                    {.lead_s = lead_s,
                     .amplitude = drift * radar_.amplitude_lsb(radar_.interferer->level_dbm)},
                    other);
            Rail rail{.channel = radar_.rx[static_cast<std::size_t>(rx)],
                      .beat = beat,
                      .noise_lsb = noise_lsb_ * drift,
                      .is_quadrature = false};
            digitise(rail, noise, frame.codes);
            if (!radar_.receiver.complex_samples) continue;
            rail.is_quadrature = true;
            digitise(rail, noise, frame.quadrature);
        }
    }
    return frame;
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
