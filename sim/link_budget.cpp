#include "sim/link_budget.hpp"

#include <cmath>

#include "sim/adc/receiver_chain.hpp"
#include "sim/clutter.hpp"
#include "sim/core/constants.hpp"

namespace specula {

namespace {

double power_db(double ratio) {
    return 10.0 * std::log10(ratio);
}

/// The mean over the IF band of what the high-pass leaves of a power.
double passed_noise(const Radar& radar) {
    constexpr int n = 512;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        const double beat_hz = (i + 0.5) / n * 0.5 * radar.chirp.sample_rate_hz;
        sum += std::pow(10.0, 0.1 * radar.receiver.high_pass_db(beat_hz));
    }
    return sum / n;
}

}  // namespace

LinkBudget mirror_budget(const Radar& radar, double height_m) {
    LinkBudget budget;
    budget.received_dbm = radar.tx_power_dbm + 20.0 * std::log10(mirror_transfer(radar, height_m));
    budget.beat_hz = radar.chirp.beat_hz(height_m);
    budget.high_pass_db = radar.receiver.high_pass_db(budget.beat_hz);
    budget.amplitude_lsb = radar.amplitude_lsb(budget.received_dbm + budget.high_pass_db);
    budget.noise_lsb = ReceiverChain(radar).noise_lsb();
    return budget;
}

double power_of_lsb_dbm(const Radar& radar, double amplitude_lsb) {
    return radar.receiver.full_scale_dbm +
           20.0 * std::log10(amplitude_lsb / radar.adc_full_scale_lsb());
}

std::vector<BudgetStage> budget_stages(const Radar& radar, double height_m) {
    const Receiver& receiver = radar.receiver;
    const LinkBudget mirror = mirror_budget(radar, height_m);
    const double boresight_dbi = power_db(gain_towards(radar.pattern, {0.0, 0.0, -1.0}));
    const double band_hz = 0.5 * radar.chirp.sample_rate_hz;
    const double thermal_dbm = power_db(boltzmann_j_k * receiver.temperature_k * band_hz * 1e3);
    const double noise_dbm = thermal_dbm + receiver.noise_figure_db + receiver.gain_db;
    const double filtered_dbm = noise_dbm + power_db(passed_noise(radar));
    // A noise of variance s^2 in one rail has the power of a tone of amplitude s sqrt(2).
    const double own_lsb2 = receiver.adc_noise_lsb * receiver.adc_noise_lsb + 1.0 / 12.0;
    const double own_dbm = power_of_lsb_dbm(radar, std::sqrt(2.0 * own_lsb2));
    const double adc_dbm =
        power_db(std::pow(10.0, 0.1 * filtered_dbm) + std::pow(10.0, 0.1 * own_dbm));
    const double echo_dbm = mirror.received_dbm;
    return {
        {"TX port", radar.tx_power_dbm, {}},
        {"radiated (EIRP)", radar.tx_power_dbm + boresight_dbi, {}},
        {"RX port, kT", echo_dbm, thermal_dbm},
        {"with noise figure", echo_dbm, thermal_dbm + receiver.noise_figure_db},
        {"behind the gain", echo_dbm + receiver.gain_db, noise_dbm},
        {"behind the high-pass", echo_dbm + receiver.gain_db + mirror.high_pass_db, filtered_dbm},
        {"in the ADC codes", echo_dbm + receiver.gain_db + mirror.high_pass_db, adc_dbm},
    };
}

}  // namespace specula
