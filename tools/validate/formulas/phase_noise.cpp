#include "tools/validate/formulas/phase_noise.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/gauss_legendre.hpp"

namespace specula {

double Oscillator::level_dbc_hz(double offset_hz) const {
    return at_1mhz_dbc_hz + slope_db_per_decade * std::log10(offset_hz / 1e6);
}

namespace {

double correlation(const DelayedNoise& noise) {
    const double sine = std::sin(pi * noise.offset_hz * noise.delay_s);
    return 4.0 * sine * sine;
}

}  // namespace

double range_correlation_db(const DelayedNoise& noise) {
    return 10.0 * std::log10(correlation(noise));
}

double residual_phase_rms_rad(const Oscillator& oscillator, const NoiseBand& band) {
    // In log f, by panels of a 40th of a decade, and no longer than a quarter turn of f tau.
    const GaussRule& rule = gauss_legendre(8);
    double sum = 0.0;
    for (double low = band.low_hz; low < band.high_hz;) {
        const double step = std::min(low * (std::pow(10.0, 0.025) - 1.0), 0.25 / band.delay_s);
        const double high = std::min(low + step, band.high_hz);
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double f = 0.5 * (low + high) + 0.5 * (high - low) * rule.nodes[i];
            const double spectrum = 2.0 * std::pow(10.0, 0.1 * oscillator.level_dbc_hz(f));
            sum += 0.5 * (high - low) * rule.weights[i] * spectrum * correlation({band.delay_s, f});
        }
        low = high;
    }
    return std::sqrt(sum);
}

}  // namespace specula
