#include "sim/adc/ramp_noise.hpp"

#include "sim/channel/path.hpp"
#include "sim/signal/dechirp.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

Radar noisy_radar(double level_dbc_hz) {
    Radar radar;
    radar.receiver.phase_noise_dbc_hz = level_dbc_hz;
    return radar;
}

/// The beat of one path.
std::vector<Complex> tone(const Radar& radar, double range_m) {
    const FrequencyComb comb = comb_of(radar.chirp);
    Channel channel = silent_channel(1, comb);
    add_path(channel, comb, {.length_m = 2.0 * range_m, .transfer = 1.0});
    return dechirp(channel, radar.chirp).analytic;
}

/// Phase errors of a tone's samples, those at the ends left out.
std::vector<double> phase_errors(const Radar& radar, double range_m,
                                 const std::vector<double>& steps) {
    const auto clean = tone(radar, range_m);
    auto noisy = clean;
    RampNoise::apply(noisy, steps);
    std::vector<double> errors;
    for (std::size_t i = 2; i + 2 < clean.size(); ++i)
        errors.push_back(std::arg(noisy[i] * std::conj(clean[i])));
    return errors;
}

TEST_CASE("an echo keeps of the phase noise what its delay leaves", "[adc][reference]") {
    const auto reference = reference_case("F08_phase_noise");
    int seen = 0;
    for (const auto& point : reference["points"]) {
        if (!point["inp"].contains("offset_hz") || point["inp"]["offset_hz"] != 1e5) continue;
        const double range_m = point["inp"]["R_m"];
        const Radar radar = noisy_radar(point["inp"]["L_1MHz_dbc_hz"]);
        if (radar.chirp.bin_of(range_m) > 0.15 * radar.chirp.n_samples) continue;  // docstring
        ++seen;
        // Flat over the IF band: both sidebands of the residual level, over half the sample rate.
        const double level = point["expect"]["L_residual_dbc_hz"];
        const double variance =
            2.0 * std::pow(10.0, 0.1 * level) * 0.5 * radar.chirp.sample_rate_hz;
        const RampNoise noise(radar);
        Stream stream({.seed = 5, .purpose = "ramp"});
        double sum = 0.0, n = 0.0;
        for (int chirp = 0; chirp < 100; ++chirp)
            for (const double error :
                 phase_errors(radar, range_m, noise.draw(tone(radar, range_m).size(), stream))) {
                sum += error * error;
                n += 1.0;
            }
        INFO(range_m << " m");
        // Mean square of n normal numbers: sqrt(2 / n) = 1.2 %, five times that; 1 % from the
        // slope.
        CHECK(sum / n == Approx(variance).epsilon(5.0 * std::sqrt(2.0 / n) + 0.01));
    }
    CHECK(seen > 0);
}

TEST_CASE("near and far echoes move together, each by its delay", "[adc]") {
    const Radar radar = noisy_radar(-89.0);
    Stream stream({.seed = 6, .purpose = "ramp"});
    const auto steps = RampNoise(radar).draw(tone(radar, 0.2).size(), stream);
    const auto near = phase_errors(radar, 0.2, steps), far = phase_errors(radar, 0.4, steps);
    for (std::size_t i = 0; i < near.size(); ++i)
        CHECK(far[i] == Approx(2.0 * near[i]).epsilon(0.01).margin(1e-7));
}

TEST_CASE("without a level there is no phase noise", "[adc]") {
    CHECK(RampNoise(Radar{}).is_silent());
    CHECK_FALSE(RampNoise(noisy_radar(-89.0)).is_silent());
}

}  // namespace
}  // namespace specula
