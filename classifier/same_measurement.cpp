#include "classifier/same_measurement.hpp"

#include <algorithm>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

std::optional<Radar> known_radar(const Dataset& frames, const Catalogue& catalogue) {
    const auto names = catalogue.radar_names();
    if (std::ranges::count(names, frames.origin.radar) == 0) return std::nullopt;
    return catalogue.radar_called(frames.origin.radar);
}

void expect_same_measurement(const Measurement& trained, const Dataset& frames,
                             const std::optional<Radar>& radar) {
    const fw_chirp& own = trained.chirp;
    const auto compare = [](const char* what, long seen, long learnt) {
        if (seen != learnt)
            throw InputError(
                format("{} = {}: the model was trained on {}, and knows nothing of any other; use "
                       "frames of that radar, or a model trained on this one",
                       what, seen, learnt));
    };
    compare("samples per chirp", frames.n_samples, own.n_samples);
    compare("antennas", frames.n_rx, own.n_rx);
    compare("chirps per frame", frames.n_chirps, own.n_chirps);
    if (!radar) return;
    const fw_chirp seen = measurement_of(*radar, trained.descriptor).chirp;
    compare("start_khz", seen.start_khz, own.start_khz);
    compare("slope_khz_us", seen.slope_khz_us, own.slope_khz_us);
    compare("sample_rate_hz", seen.sample_rate_hz, own.sample_rate_hz);
    compare("skip_samples", seen.skip_samples, own.skip_samples);
    compare("high_pass_hz_10", seen.high_pass_hz_10, own.high_pass_hz_10);
    compare("gain_db_100", seen.gain_db_100, own.gain_db_100);
    compare("adc_bits", seen.adc_bits, own.adc_bits);
}

}  // namespace specula
