#include "sim/adc/receiver_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/adc/high_pass.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

/// kTF over the band of a real-sampled signal, fs/2, in dBm.
double noise_power_dbm(const Receiver& receiver, double sample_rate_hz) {
    const double watt = boltzmann_j_k * receiver.temperature_k * 0.5 * sample_rate_hz;
    return 10.0 * std::log10(watt * 1e3) + receiver.noise_figure_db;
}

std::int16_t quantise(double lsb, double full_scale) {
    return static_cast<std::int16_t>(
        std::clamp(std::nearbyint(lsb), -full_scale, full_scale - 1.0));
}

}  // namespace

ReceiverChain::ReceiverChain(const Radar& radar)
    : radar_(radar),
      signal_lsb_(radar.amplitude_lsb(radar.tx_power_dbm)),
      noise_lsb_(radar.amplitude_lsb(noise_power_dbm(radar.receiver, radar.chirp.sample_rate_hz)) /
                 std::numbers::sqrt2) {
    const FrequencyComb comb = comb_of(radar.chirp);
    for (int i = 0; i < comb.n; ++i)
        wavenumber_rad_m_.push_back(two_pi * comb.at(i) / speed_of_light_m_s);
}

AdcFrame ReceiverChain::receive(const ReceiverInput& input, const FrameState& state,
                                Stream& noise) const {
    const int n_rx = static_cast<int>(radar_.rx.size());
    const int settle = radar_.chirp.settle_samples();
    SPECULA_EXPECT(input.echo.n_rx == n_rx && input.still.n_rx == n_rx);
    const double drift = std::pow(10.0, state.gain_db / 20.0);
    const double gain = signal_lsb_ * drift, noise_lsb = noise_lsb_ * drift;
    const auto n_samples = static_cast<std::size_t>(input.echo.n_samples);
    std::vector<Complex> turn(n_samples);
    for (std::size_t i = 0; i < n_samples; ++i)
        turn[i] = std::polar(gain, 2.0 * wavenumber_rad_m_[i] * state.displacement_m);

    AdcFrame frame{.n_chirps = radar_.chirps_per_frame,
                   .n_rx = n_rx,
                   .n_samples = radar_.chirp.n_samples,
                   .codes = {}};
    frame.codes.reserve(static_cast<std::size_t>(frame.n_chirps) * radar_.rx.size() *
                        static_cast<std::size_t>(frame.n_samples));
    for (int chirp = 0; chirp < frame.n_chirps; ++chirp) {
        for (int rx = 0; rx < n_rx; ++rx) {
            const ReceiveChannel& channel = radar_.rx[static_cast<std::size_t>(rx)];
            const double polarity = channel.inverted ? -1.0 : 1.0;
            const Complex* echo = input.echo.of_rx(rx);
            const Complex* still = input.still.of_rx(rx);
            HighPass filter(radar_.receiver.high_pass_hz, radar_.chirp.sample_rate_hz);
            for (int i = 0; i < input.echo.n_samples; ++i) {
                const double arriving = (echo[i] * turn[static_cast<std::size_t>(i)]).real() +
                                        gain * still[i].real();
                const double filtered =
                    filter.step(polarity * arriving + noise_lsb * noise.normal());
                if (i >= settle)
                    frame.codes.push_back(
                        quantise(filtered + channel.dc_offset_lsb, radar_.adc_full_scale_lsb()));
            }
        }
    }
    return frame;
}

}  // namespace specula
