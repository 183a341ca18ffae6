#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "classifier/augment.hpp"
#include "classifier/step_draw.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

using Complex = std::complex<double>;

void scale(FrameSamples& frame, double factor) {
    for (double& sample : frame.in_phase) sample *= factor;
    for (double& sample : frame.quadrature) sample *= factor;
}

void add_noise(FrameSamples& frame, double sd_lsb, Stream& stream) {
    for (double& sample : frame.in_phase) sample += sd_lsb * stream.normal();
    for (double& sample : frame.quadrature) sample += sd_lsb * stream.normal();
}

/// The same tone in every chirp, of a phase of its own in every RX.
void add_tone(FrameSamples& frame, const Tone& tone, Stream& stream) {
    std::vector<double> phase_rad(static_cast<std::size_t>(frame.n_rx));
    for (double& phase : phase_rad) phase = two_pi * stream.uniform();
    const auto n = static_cast<std::size_t>(frame.n_samples);
    const double turn_rad = two_pi * tone.bin / frame.n_samples;
    for (std::size_t i = 0; i < frame.in_phase.size(); ++i) {
        const double angle_rad =
            phase_rad[i / n % phase_rad.size()] + turn_rad * static_cast<double>(i % n);
        frame.in_phase[i] += tone.amplitude_lsb * std::cos(angle_rad);
        if (!frame.quadrature.empty())
            frame.quadrature[i] += tone.amplitude_lsb * std::sin(angle_rad);
    }
}

/// Moves what lies from `first_moved_bin` on, row by row.
class Mover {
  public:
    Mover(const FrameSamples& frame, const Move& move, const RadarView& radar)
        : n_(static_cast<std::size_t>(frame.n_samples)),
          is_complex_(!frame.quadrature.empty()),
          factor_(n_, 0.0) {
        // Of a real signal, the upper half mirrors the lower: it goes, and the lower counts twice.
        for (std::size_t k = 0; k < n_; ++k) {
            if (!is_far(k) || (!is_complex_ && 2 * k > n_)) continue;
            const double from = static_cast<double>(k);
            const bool passes_filter = !move.keeps_level && 2 * k < n_;
            factor_[k] = (is_complex_ || 2 * k == n_ ? 1.0 : 2.0) * move.level *
                         (passes_filter ? high_pass_ratio(radar, from, from + move.bins) : 1.0);
        }
        const double turn_rad = two_pi * move.bins / frame.n_samples;
        for (std::size_t i = 0; i < n_; ++i)
            ramp_.push_back(std::polar(1.0, move.phase_rad + turn_rad * static_cast<double>(i)));
    }

    void move(double* in_phase, double* quadrature) {
        std::vector<Complex> signal(n_), spectrum, moved;
        for (std::size_t i = 0; i < n_; ++i)
            signal[i] = {in_phase[i], is_complex_ ? quadrature[i] : 0.0};
        fft_.fwd(spectrum, signal);
        std::vector<Complex> still = spectrum;
        for (std::size_t k = 0; k < n_; ++k) {
            if (is_far(k)) still[k] = 0.0;
            spectrum[k] *= factor_[k];
        }
        fft_.inv(moved, spectrum);
        fft_.inv(signal, still);
        for (std::size_t i = 0; i < n_; ++i) {
            const Complex value = signal[i] + moved[i] * ramp_[i];
            in_phase[i] = value.real();
            if (is_complex_) quadrature[i] = value.imag();
        }
    }

  private:
    /// Bins that move, or that mirror one which does.
    bool is_far(std::size_t k) const { return k >= first_moved_bin && k + first_moved_bin <= n_; }

    std::size_t n_;
    bool is_complex_;
    std::vector<Complex> factor_;  ///< (bin): of what moves
    std::vector<Complex> ramp_;    ///< (sample)
    Eigen::FFT<double> fft_;
};

/// Range of the strongest bin beyond leakage, of all rows together.
double strongest_range_m(const FrameSamples& frame, const RadarView& radar) {
    const auto n = static_cast<std::size_t>(frame.n_samples);
    std::vector<double> power(n, 0.0);
    Eigen::FFT<double> fft;
    std::vector<Complex> signal(n), spectrum;
    for (std::size_t row = 0; row * n < frame.in_phase.size(); ++row) {
        for (std::size_t i = 0; i < n; ++i) {
            const double window = 0.5 - 0.5 * std::cos(two_pi * (static_cast<double>(i) + 0.5) /
                                                       static_cast<double>(n));
            signal[i] = window * frame.in_phase[row * n + i];
        }
        fft.fwd(spectrum, signal);
        for (std::size_t k = 0; k < n; ++k) power[k] += std::norm(spectrum[k]);
    }
    const std::size_t first = std::min(first_moved_bin + 1, n - 1);
    const auto begin = power.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = power.begin() + static_cast<std::ptrdiff_t>(std::max(first + 1, n / 2));
    return static_cast<double>(std::max_element(begin, end) - power.begin()) * radar.bin_m;
}

}  // namespace

std::vector<double> augment_codes(FrameSamples& frame, const Augmentation& how, double range_m,
                                  const StreamKey& key) {
    if (range_m < 0.0 && needs_range(how)) range_m = strongest_range_m(frame, how.radar);
    std::vector<double> drawn;
    for (std::size_t i = 0; i < how.steps.size(); ++i) {
        StepDraw draw(how.steps[i], how.radar, {.key = key, .step = i});
        drawn.push_back(draw.value());
        if (draw.is<NoiseStep>()) add_noise(frame, draw.value(), draw.stream());
        if (draw.is<GainStep>()) scale(frame, std::pow(10.0, draw.value() / 20.0));
        if (const auto tone = draw.tone()) add_tone(frame, *tone, draw.stream());
        if (const auto move = draw.move(range_m)) {
            Mover mover(frame, *move, how.radar);
            const auto n = static_cast<std::size_t>(frame.n_samples);
            for (std::size_t at = 0; at < frame.in_phase.size(); at += n)
                mover.move(&frame.in_phase[at],
                           frame.quadrature.empty() ? nullptr : &frame.quadrature[at]);
            range_m += draw.value();
        }
    }
    return drawn;
}

}  // namespace specula
