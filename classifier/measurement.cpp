#include "classifier/measurement.hpp"

#include <cmath>
#include <limits>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

template <typename Integer>
Integer whole(const char* what, double value) {
    const double rounded = std::round(value);
    if (!(rounded >= static_cast<double>(std::numeric_limits<Integer>::min()) &&
          rounded <= static_cast<double>(std::numeric_limits<Integer>::max())))
        throw InputError(
            format("{} = {}: does not fit the firmware's chirp fingerprint; use a "
                   "radar that the firmware can run",
                   what, value));
    return static_cast<Integer>(rounded);
}

}  // namespace

Measurement measurement_of(const Radar& radar, const fw_extract_config& descriptor) {
    const Chirp& chirp = radar.chirp;
    const Receiver& receiver = radar.receiver;
    Measurement measurement;
    measurement.descriptor = descriptor;
    measurement.chirp = {
        .start_khz = whole<std::uint32_t>("start_khz", chirp.start_hz / 1e3),
        .slope_khz_us = whole<std::int32_t>("slope_khz_us", chirp.slope_hz_s / 1e9),
        .sample_rate_hz = whole<std::uint32_t>("sample_rate_hz", chirp.sample_rate_hz),
        .n_samples = whole<std::uint16_t>("n_samples", chirp.n_samples),
        .skip_samples = whole<std::uint16_t>("skip_samples", chirp.skip_samples),
        .n_rx = whole<std::uint16_t>("n_rx", static_cast<double>(radar.rx.size())),
        .n_chirps = whole<std::uint16_t>("chirps_per_frame", radar.chirps_per_frame),
        .high_pass_hz_10 = whole<std::uint16_t>("high_pass_hz_10", receiver.high_pass_hz / 10.0),
        .gain_db_100 = whole<std::int16_t>("gain_db_100", receiver.gain_db * 100.0),
        .adc_bits = whole<std::uint16_t>("adc_bits", receiver.adc_bits)};
    return measurement;
}

}  // namespace specula
