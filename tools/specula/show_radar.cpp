#include "tools/specula/show_radar.hpp"

#include <cmath>
#include <cstdio>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/link_budget.hpp"

namespace specula {

namespace {

void show_chirp(const Radar& radar) {
    const Chirp& chirp = radar.chirp;
    std::printf("ramp               %.6g to %.6g GHz in %.4g us, %.4g MHz/us\n",
                chirp.start_hz * 1e-9,
                (chirp.start_hz + chirp.slope_hz_s * chirp.ramp_end_s) * 1e-9,
                chirp.ramp_end_s * 1e6, chirp.slope_hz_s * 1e-12);
    std::printf("sampled            %.4g to %.4g GHz, %.4g GHz, %.4g MHz\n",
                chirp.frequency_hz(0) * 1e-9, chirp.frequency_hz(chirp.n_samples) * 1e-9,
                chirp.bandwidth_hz() * 1e-9, chirp.sample_rate_hz * 1e-6);
    std::printf("range bin          %.4g cm, farthest range %.4g m\n", chirp.bin_m() * 100.0,
                chirp.max_range_m());
    const std::string mimo = radar.n_tx() == 1
                                 ? ""
                                 : format(" of {} TX by {}", radar.n_tx(),
                                          radar.multiplexing == Multiplexing::tdm ? "TDM" : "BPM");
    std::printf("frame              %d chirps%s x %zu RX x %d %s samples\n", radar.chirps_per_frame,
                mimo.c_str(), radar.rx.size(), chirp.n_samples,
                radar.receiver.complex_samples ? "complex" : "real");
    if (radar.chirps_per_frame > radar.n_tx()) {
        const double loop_s = radar.n_tx() * chirp.period_s();
        const double wavelength_m = speed_of_light_m_s / chirp.centre_hz();
        std::printf("velocity           within %.4g m/s, steps of %.4g m/s\n",
                    wavelength_m / (4.0 * loop_s),
                    wavelength_m / (2.0 * chirp.period_s() * radar.chirps_per_frame));
    }
    if (chirp.settle_samples() < 0)
        std::printf(
            "start-up           %d samples before the ramp shows; the TX sends from %.4g us "
            "on\n",
            -chirp.settle_samples(), chirp.tx_on_s * 1e6);
    if (!radar.limits.chip.empty())
        std::printf("limits             within those of %s\n", radar.limits.chip.c_str());
}

void show_budget(const Radar& radar, double height_m) {
    const LinkBudget mirror = mirror_budget(radar, height_m);
    const Receiver& receiver = radar.receiver;
    std::printf(
        "\nan infinite mirror at %.4g mm falls into bin %.2f, beat %.4g kHz, where the IF "
        "high-pass\n(%.4g kHz) takes %.2f dB; powers in dBm, noise over half the sample "
        "rate:\n",
        height_m * 1e3, radar.chirp.bin_of(height_m), mirror.beat_hz * 1e-3,
        receiver.high_pass_hz * 1e-3, -mirror.high_pass_db);
    std::printf("  %-22s %9s %9s\n", "", "echo", "noise");
    for (const BudgetStage& stage : budget_stages(radar, height_m))
        std::printf("  %-22s %9.1f %9s\n", stage.name, stage.echo_dbm,
                    stage.noise_dbm ? format("{:.1f}", *stage.noise_dbm).c_str() : "");
    const double adc_noise_dbm = *budget_stages(radar, height_m).back().noise_dbm;
    const double noise_lsb = radar.adc_full_scale_lsb() / std::sqrt(2.0) *
                             std::pow(10.0, (adc_noise_dbm - receiver.full_scale_dbm) / 20.0);
    std::printf("  %-22s %9.1f %9.2f\n", "  in LSB (peak, rms)", mirror.amplitude_lsb, noise_lsb);
    std::printf("  %-22s %9.1f\n", "  in dB of full scale",
                20.0 * std::log10(mirror.amplitude_lsb / radar.adc_full_scale_lsb()));
    // A Blackman window spreads noise over 1.73 bins.
    std::printf("  one chirp's signal over noise in its bin (Blackman window): %.1f dB\n",
                20.0 * std::log10(mirror.amplitude_lsb / (noise_lsb * std::sqrt(2.0))) +
                    10.0 * std::log10(0.5 * radar.chirp.n_samples / 1.73));
    if (mirror.amplitude_lsb > radar.adc_full_scale_lsb())
        std::printf("  a mirror saturates the ADC there\n");
}

void show_leakage(const Radar& radar) {
    if (radar.leakage.empty()) return;
    std::printf("\n  %-4s %-4s %9s %9s %9s %11s %9s\n", "RX", "TX", "range mm", "RX port", "gain",
                "high-pass", "LSB");
    for (const Leakage& leak : radar.leakage) {
        const double behind_db = radar.receiver.high_pass_db(radar.chirp.beat_hz(leak.range_m));
        std::printf("  %-4d %-4s %9.4g %9.1f %9.1f %11.1f %9.1f\n", leak.rx,
                    leak.tx ? std::to_string(*leak.tx).c_str() : "each", leak.range_m * 1e3,
                    leak.level_dbm, leak.level_dbm + radar.receiver.gain_db,
                    leak.level_dbm + radar.receiver.gain_db + behind_db,
                    radar.amplitude_lsb(leak.level_dbm + behind_db));
    }
}

}  // namespace

void show_radar(const Radar& radar, double height_m) {
    std::printf("%s: %s\nsource: %s\n\n", radar.name.c_str(), radar.title.c_str(),
                radar.source.c_str());
    show_chirp(radar);
    show_budget(radar, height_m);
    show_leakage(radar);
}

}  // namespace specula
