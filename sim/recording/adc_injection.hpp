#pragma once

#include <vector>

#include "sim/recording/byte_span.hpp"

namespace specula {

/// What TI's demo reads instead of the ADC (`adcDataSource 1 FILE`).
///
/// Header of four u32: samples per chirp, virtual antennas (n_rx * n_tx), chirps per frame (of each
/// TX), frames. Then, chirp by chirp (the TX taking turns), int16 (rx, sample). Little-endian.
/// @eq  TI mmWave L-SDK adc_testbuf.c
struct AdcInjection {
    std::size_t n_samples = 0;
    std::size_t n_virtual = 0;
    std::size_t n_chirps = 0;  ///< per frame and TX
    std::size_t n_frames = 0;
    std::vector<std::int16_t> codes{};  ///< (frame, chirp, tx, rx, sample)
};

/// Throws InputError with the byte where the header is impossible or the codes do not fit it.
AdcInjection read_adc_injection(Bytes bytes);

std::string write_adc_injection(const AdcInjection& injection);

}  // namespace specula
