#pragma once

#include "firmware/fw_model.h"
#include "scenes/radar.hpp"

namespace specula {

/// How features came about: the radar's chirp as a fingerprint, the firmware's extractor, and
/// fw_normalise behind it. A classifier is good for these alone.
struct Measurement {
    fw_chirp chirp{};
    fw_extract_config descriptor{};
    fw_normalise_config normalise{};
    /// Bins in which the peak is looked for, where `normalise` needs one; none: the descriptor's.
    std::uint16_t search_first = 0, n_search = 0;
};

/// The fingerprint of a radar. Frequencies are rounded to whole kHz or Hz, finer than the steps of
/// the IWRL6432 (1.17 MHz, 28.6 kHz/us).
/// Throws InputError where a number does not fit, e.g. a sample rate above 4.29 GHz.
Measurement measurement_of(const Radar& radar, const fw_extract_config& descriptor);

}  // namespace specula
